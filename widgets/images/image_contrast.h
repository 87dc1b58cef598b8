// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace handsight::widgets {

/// The image with its grey levels spread over all that a screen has, but for the darkest and the palest half percent;
/// the image itself where it uses most of them already.
QImage with_stretched_contrast(const QImage& image);

}  // namespace handsight::widgets
