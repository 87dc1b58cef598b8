// SPDX-License-Identifier: Apache-2.0
// What touches cannot tell, in words.
#pragma once

#include <array>

#include "base/message.h"
#include "estimation/fit/fit_result.h"

namespace handsight {

/// Sentences for people, of a session of touches: what of the tip and of the fixtures no touch determines, and which
/// joints' zeros another place of tip or fixtures would hide. Empty where all of it is reported.
std::vector<Message> touch_unknown_texts(const Session& session, const Fit& fit);

/// What nothing determines, of a session of any kind: touch_unknown_texts or undetermined_texts.
std::vector<Message> unknown_texts(const Session& session, const Fit& fit);

/// Of the tip's place on the hand (x y z in the TCP's frame): what no touch tells. All false of other sessions.
std::array<bool, 3> undetermined_tip(const Session& session, const Fit& fit);

/// Of each fixture: is a number of its place not determined?
std::vector<char> undetermined_fixtures(const Session& session, const Fit& fit);

/// Gives a factor of the covariance of the problem's columns one column more for each direction that no touch tells, as
/// long as what stands for a length of which nothing is known (chain/unknown_angle.h). Only for sessions of touches.
void add_undetermined_columns_of_touches(const Session& session, const Fit& fit, Eigen::MatrixXd& factor);

/// Do touches say nothing of this number of an effect (an index into Fit::effects, and of its parameter), so that its
/// sigma is still that of what is usual? False of other sessions and of what is held.
bool is_left_at_prior(const Session& session, const Fit& fit, std::size_t term, std::size_t parameter);

/// InputError, with what to touch next, where touches leave more than one number of a tip's place open, or one of a fit
/// that did not converge.
void require_determined(const Session& session, const Fit& fit);

}  // namespace handsight
