// SPDX-License-Identifier: Apache-2.0
// The model as it stands, fitted without the points and observations that are wrong whatever may be missing in it.
#pragma once

#include "diagnosis/outliers/snooping.h"

namespace handsight {

/// As clean_fit, but points that an effect of the catalogue would make right (of single markers, of the cameras) stay
/// in; and without lone observations. What diagnose() and improve() fit, and the window. Which points are wrong is
/// found with the image objective and free markers; the fit of the rest is that of the options.
CleanFit fit_without_outliers(const Session& session, const FitOptions& options);

}  // namespace handsight
