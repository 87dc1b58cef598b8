// SPDX-License-Identifier: Apache-2.0
// Places of blunders as text, and the joints of a session by name.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "session/session.h"

namespace handsight {

/// "a,b" in two; InputError where there are not two words.
std::pair<std::string, std::string> two_words(const std::string& where, const std::string& id);

/// "a=b" in two; the second is empty where there is no "=".
std::pair<std::string, std::string> name_and_value(const std::string& where);

/// "a,b,c" word by word; one empty word of an empty text.
std::vector<std::string> words_of_list(const std::string& where);

/// The number of a value; InputError where it is none.
double number_in(const std::string& value, const std::string& id);

/// The joint's place in Observation::position; InputError names those that there are.
Eigen::Index joint_place(const Session& session, const std::string& name, const std::string& id);

/// The robot's joint of that name, of those in Session::joints.
const Joint& joint_named(const Session& session, const std::string& name);

/// The joints of Session::joints that move the hand against the sensor; none where poses stand for the robot.
std::vector<std::string> telling_joints(const Session& session);

/// What sentences call the file of the session, and that of its robot.
std::string session_name(const Session& session);
Message robot_name(const Session& session);

}  // namespace handsight
