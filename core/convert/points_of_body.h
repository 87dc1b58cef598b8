// SPDX-License-Identifier: Apache-2.0
// Points that a tracker measured one after the other, as the markers of one body. Internal to convert.
#pragma once

#include <optional>
#include <vector>

#include "readers/series.h"

namespace handsight {

/// Do the points of each instant keep their distances from one instant to the next, as those of one body do?
bool are_of_one_body(const PointSeries& points);

/// Both files' points as the markers of one body, `more`'s last. Nothing where they have not as many rows, or the
/// points do not keep their distances.
std::optional<PointSeries> with_more_markers(const PointSeries& points, const PointSeries& more);

/// Lines of one point each, as many of them for each of `instants`: the markers of one body. Nothing where the number
/// does not come out even, or the points do not keep their distances.
std::optional<PointSeries> markers_line_by_line(const PointSeries& points, std::size_t instants);

/// Of lines of one point each the marker that `numbers` say (whole numbers, in the order of which they are counted).
/// InputError where there is no number to each line, or one is not whole.
PointSeries markers_by_number(const PointSeries& points, const std::vector<double>& numbers);

}  // namespace handsight
