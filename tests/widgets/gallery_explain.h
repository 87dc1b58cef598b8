// SPDX-License-Identifier: Apache-2.0
// The Explain workspace's part of the gallery.
#pragma once

#include <QSize>
#include <QString>
#include <functional>

class QWidget;

namespace handsight::test {

using KeepPicture = std::function<void(QWidget& widget, const QString& name, const QSize& size)>;

/// A picture of each widget and of its states.
void explain_pictures(const KeepPicture& keep);

/// Times of painting, to standard output: ms a repaint of PatternPage and ResidualCloud with 1000 observations.
void explain_times();

}  // namespace handsight::test
