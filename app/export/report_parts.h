// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a report as HTML, in the order in which they are read.
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "document/document.h"
#include "export/report_content.h"
#include "export/report_pages.h"

namespace handsight::app {

enum class Pages { of_paper, of_a_browser };

constexpr int picture_width = 600;  // of the page's px

/// A row a cause; what stands in for another one in amber.
QString bill_part(const std::vector<widgets::BillEntry>& bill);

/// The first page: what there is to say, before any number.
QString story_part(const Document& document, const ReportStory& story);

/// Story, pictures and bill. `source` gives the picture's address: inside the file, or of a resource.
QString seen_part(const Document& document, const std::vector<ReportPicture>& pictures,
                  const std::vector<PlacedPicture>& placed, const ReportStory& story, Pages pages,
                  const std::function<QString(std::size_t)>& source);

/// TCP->Body.
QString hand_part(const ModelVersion& model, Pages pages, bool on_a_new_page);

/// What follows the numbers of the hand: effects, fit, decisions, checks and actions.
QString rest_part(const Document& document, const ModelVersion& model);

}  // namespace handsight::app
