// SPDX-License-Identifier: Apache-2.0
// A table of legal but odd sessions, ten robots by thirty oddities; every command is run on each. It must end by itself
// with exit code 0, 1 or 2, tell only finite numbers, and refuse in one sentence.
//   odd_sessions [--every N] [--only NUMBER] [--keep FOLDER]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <regex>

#include "base/files.h"
#include "chain/chain.h"
#include "cli/cli_runner.h"
#include "fixtures/drawn.h"
#include "robot/urdf.h"
#include "session/session_xml.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;
using test::CliResult;

constexpr int most_seconds = 120;  // of one run: it hangs

// ---- robots
// ----------------------------------------------------------------------------------------------------------

struct OddRobot {
  std::string name, urdf, tcp;
  double size = 1;  // m, about
};

std::string link(int i, double mass, double length) {
  const std::string inertial =
      mass > 0 ? fmt::format("<inertial><origin xyz=\"0 0 {}\"/><mass value=\"{}\"/></inertial>", length / 2, mass)
               : "";
  return fmt::format("<link name=\"l{}\">{}</link>\n", i, inertial);
}

/// A chain of joints about z, y, x in turn; `kinds` are taken in turn too.
std::string chain_urdf(int joints, double length, double mass, const std::vector<std::string>& kinds,
                       const std::string& within_joints = "") {
  std::string text = "<robot name=\"odd\">\n" + link(0, 0, 0);
  const char* const axes[] = {"0 0 1", "0 1 0", "1 0 0"};
  for (int j = 1; j <= joints; ++j) {
    const std::string kind = kinds[static_cast<std::size_t>(j) % kinds.size()];
    const double reach = kind == "prismatic" ? 0.5 * length + 0.2 : 1.5;
    text += link(j, mass, length) +
            fmt::format(
                "<joint name=\"j{0}\" type=\"{1}\"><parent link=\"l{2}\"/><child link=\"l{0}\"/><origin xyz=\"0 0 "
                "{3}\"/><axis xyz=\"{4}\"/><limit lower=\"{5}\" upper=\"{6}\"/>{7}</joint>\n",
                j, kind, j - 1, length, axes[j % 3], -reach, reach, within_joints);
  }
  return text + "</robot>\n";
}

std::vector<OddRobot> odd_robots() {
  const std::string follower =
      "<link name=\"f\"/><joint name=\"follower\" type=\"revolute\"><parent link=\"l4\"/><child link=\"f\"/><origin "
      "xyz=\"0 0 "
      "0.1\"/><axis xyz=\"0 1 0\"/><limit lower=\"-3\" upper=\"3\"/><mimic joint=\"j1\" multiplier=\"-0.5\"/><mimic "
      "joint=\"j2\" offset=\"0.1\"/></joint></robot>";
  std::string mimics = chain_urdf(4, 0.25, 1, {"revolute"}, "<stiffness value=\"500\"/>");
  mimics.replace(mimics.find("</robot>"), 8, follower);
  return {{"six axes", chain_urdf(6, 0.2, 2, {"revolute"}), "l6"},
          {"one joint", chain_urdf(1, 0.5, 1, {"revolute"}), "l1"},
          {"gantry", chain_urdf(3, 0.3, 5, {"prismatic"}), "l3"},
          {"mixed", chain_urdf(4, 0.2, 1, {"prismatic", "revolute"}), "l4"},
          {"no length", chain_urdf(3, 0, 1, {"revolute"}), "l3", 0.1},
          {"hundred joints", chain_urdf(100, 0.01, 0.1, {"revolute"}), "l100"},
          {"tiny", chain_urdf(4, 3e-4, 1e-6, {"revolute"}), "l4", 1e-3},
          {"giant", chain_urdf(4, 20, 5000, {"revolute"}, "<stiffness value=\"1e9\"/>"), "l4", 60},
          {"springs that follow", mimics, "f"},
          {"massless and turning on", chain_urdf(5, 0.2, 0, {"continuous"}), "l5"}};
}

// ---- sessions
// --------------------------------------------------------------------------------------------------------

struct Plan {
  bool tracker = false, exact = false, collinear = false, coincident = false, one_pose = false, two_poses = false;
  int observations = 14, markers = 3, moving_joints = 1000;
  std::function<void(Session&, std::mt19937&)> change = [](Session&, std::mt19937&) {};
};

void keep_only(Session& s, const std::function<void(std::size_t observation, std::vector<Sighting>&)>& keep) {
  for (std::size_t k = 0; k < s.observations.size(); ++k) keep(k, s.observations[k].sightings);
}

void one_camera(Session& s, const std::function<bool(std::size_t observation)>& is_left) {
  keep_only(s, [&](std::size_t k, std::vector<Sighting>& seen) {
    for (Sighting& sighting : seen) forget(sighting, is_left(k) ? 1 : 0);
    std::erase_if(seen, [](const Sighting& x) { return x.in_cameras.empty() && !x.point; });
  });
}

struct Oddity {
  std::string name;
  Plan plan;
};

std::vector<Oddity> odd_things() {
  std::vector<Oddity> all;
  const auto add = [&](std::string name, Plan plan) { all.push_back({std::move(name), std::move(plan)}); };
  const auto changed = [&](std::string name, std::function<void(Session&, std::mt19937&)> change, Plan plan = {}) {
    plan.change = std::move(change);
    add(std::move(name), plan);
  };
  add("nothing odd", {});
  add("tracker", {.tracker = true});
  for (const int count : {1, 2, 9, 10}) add(fmt::format("{} observations", count), {.observations = count});
  add("one pose", {.one_pose = true});
  add("two poses", {.tracker = true, .two_poses = true});
  add("one joint moves", {.moving_joints = 1});
  for (const int count : {1, 2, 64}) add(fmt::format("{} markers", count), {.markers = count});
  add("one marker before a tracker", {.tracker = true, .markers = 1});
  add("markers on a line", {.collinear = true});
  add("markers in one place", {.tracker = true, .coincident = true});
  add("no noise", {.exact = true});
  changed("left camera only", [](Session& s, std::mt19937&) { one_camera(s, [](std::size_t) { return true; }); });
  changed("cameras in turn",
          [](Session& s, std::mt19937&) { one_camera(s, [](std::size_t k) { return k % 2 == 0; }); });
  changed("one marker at a time",
          [](Session& s, std::mt19937&) {
            keep_only(s, [](std::size_t k, std::vector<Sighting>& seen) {
              std::erase_if(seen, [&](const Sighting& x) { return x.marker != static_cast<int>(k % 3); });
            });
          },
          {.tracker = true});
  changed("a marker that is never seen", [](Session& s, std::mt19937&) {
    keep_only(s, [](std::size_t, std::vector<Sighting>& seen) {
      std::erase_if(seen, [](const Sighting& x) { return x.marker == 2; });
    });
  });
  changed("nothing labelled", [](Session& s, std::mt19937&) {
    keep_only(s, [](std::size_t, std::vector<Sighting>& seen) { seen.clear(); });
  });
  changed("all rejected", [](Session& s, std::mt19937&) {
    for (Observation& o : s.observations) o.decision = Decision::rejected;
  });
  changed("declared noise of nothing", [](Session& s, std::mt19937&) { s.sigma_pixel = 1e-9; });
  changed("declared noise beyond all", [](Session& s, std::mt19937&) { s.sigma_point = 1e3; }, {.tracker = true});
  changed("mount guessed", [](Session& s, std::mt19937&) { s.mount.estimate = true; });
  changed("mount unknown", [](Session& s, std::mt19937&) { s.mount.estimate = true, s.mount.known = false; });
  changed("times and ids of another world", [](Session& s, std::mt19937&) {
    for (Observation& o : s.observations) o.time = 1.7e18, o.id = INT64_MAX - o.id;
  });
  changed("velocities and torques", [](Session& s, std::mt19937& random) {
    std::normal_distribution<double> normal;
    for (Observation& o : s.observations) {
      o.velocity = o.torque = o.position;
      for (double& v : o.velocity) v = normal(random);
      for (double& t : o.torque) t = 1e8 * normal(random);
    }
  });
  changed("no gravity", [](Session& s, std::mt19937&) { s.gravity.setZero(); });
  changed("every third point is anywhere", [](Session& s, std::mt19937& random) {
    std::uniform_real_distribution<double> anywhere(0, 600);
    int count = 0;
    for (Observation& o : s.observations)
      for (Sighting& x : o.sightings)
        if (++count % 3 == 0 && seen_by(x, 0)) see(x, 0, fixture::drawn_2([&] { return anywhere(random); }));
  });
  return all;
}

Rigid look_at(const Vector3& eye, const Vector3& target) {
  Matrix3 r;
  r.col(2) = (target - eye).normalized();
  r.col(0) = r.col(2).cross(std::abs(r(2, 2)) < 0.9 ? Vector3::UnitZ() : Vector3::UnitX()).normalized();
  r.col(1) = r.col(2).cross(r.col(0));
  return {r, eye};
}

std::vector<Vector3> count_markers(const Plan& plan, double size, std::mt19937& random) {
  std::uniform_real_distribution<double> side(-0.06 * size, 0.06 * size);
  std::vector<Vector3> markers;
  for (int m = 0; m < plan.markers; ++m) {
    const double x = side(random), y = side(random), z = 0.3 * side(random);
    markers.push_back(plan.coincident ? Vector3(0.01, 0, 0) : plan.collinear ? Vector3(x, 0, 0) : Vector3(x, y, z));
  }
  return markers;
}

void draw_positions(Session& s, const Plan& plan, std::mt19937& random) {
  for (int k = 0; k < plan.observations; ++k) {
    Observation& o = s.observations.emplace_back();
    o.id = k;
    o.time = 2.5 * k;
    o.position = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(s.joints.size()));
    if (plan.one_pose && k > 0) o.position = s.observations.front().position;
    if (plan.two_poses && k > 1) o.position = s.observations[static_cast<std::size_t>(k % 2)].position;
    if ((plan.one_pose && k > 0) || (plan.two_poses && k > 1)) continue;
    for (Eigen::Index j = 0; j < std::min<Eigen::Index>(o.position.size(), plan.moving_joints); ++j) {
      const Joint& joint =
          s.robot.joints[static_cast<std::size_t>(find_joint(s.robot, s.joints[static_cast<std::size_t>(j)]))];
      const double reach = std::isfinite(joint.upper) ? std::min(joint.upper, 1.0) : 1.0;
      o.position[j] = std::uniform_real_distribution<double>(-reach, reach)(random);
    }
  }
}

/// What the sensor sees of the markers, from where it sees the hand whatever the robot does.
void see(Session& s, const Plan& plan, double size, std::mt19937& random) {
  const Chain chain = make_chain(s);
  const std::vector<Vector3> markers = count_markers(plan, size, random);
  std::vector<Rigid> root_from_tcp;
  Vector3 middle = Vector3::Zero();
  for (const Observation& o : s.observations) {
    root_from_tcp.push_back(chain_ends(chain, o.position).root_from_tcp);
    middle += root_from_tcp.back().translation / static_cast<double>(s.observations.size());
  }
  double spread = 0.2 * size;
  for (const Rigid& tcp : root_from_tcp) spread = std::max(spread, (tcp.translation - middle).norm());
  s.mount.mount_from_sensor = look_at(middle + 3 * spread * Vector3(0.8, 0.5, 0.3), middle);
  const Camera camera{.width = 1024, .height = 768, .fx = 900, .fy = 900, .cx = 512, .cy = 384};
  const StereoRig rig{camera, camera, {Matrix3::Identity(), Vector3(-0.4 * spread, 0, 0)}};
  if (!plan.tracker) s.rig = make_rig(rig);
  std::normal_distribution<double> normal(0, plan.exact ? 0 : 1);
  const auto noise = [&](double sigma) { return sigma * normal(random); };
  for (std::size_t k = 0; k < s.observations.size(); ++k)
    for (int m = 0; m < plan.markers; ++m) {
      const Vector3 x = inverse(s.mount.mount_from_sensor) * (root_from_tcp[k] * markers[static_cast<std::size_t>(m)]);
      Sighting sighting{.marker = m};
      if (plan.tracker) {
        sighting.point = x + 1e-4 * size * fixture::drawn_3([&] { return noise(1); });
      } else {
        const auto off = [&] { return fixture::drawn_2([&] { return noise(0.2); }); };
        see(sighting, 0, project(rig.left, x) + off());
        see(sighting, 1, project(rig.right, Vector3(rig.right_from_left * x)) + off());
      }
      s.observations[k].sightings.push_back(sighting);
    }
}

void write_session(const OddRobot& robot, const Oddity& odd, unsigned seed, const fs::path& where) {
  fs::create_directories(where);
  std::mt19937 random(seed);
  Session s;
  s.file = where / "session.xml";
  s.title = robot.name + ": " + odd.name;
  s.robot_file = "robot.urdf";
  s.robot = parse_urdf(robot.urdf, "robot.urdf", nullptr);
  s.tcp = robot.tcp;
  s.mount.link = "l0";
  s.marker_count = odd.plan.markers;
  for (const Joint& joint : s.robot.joints)
    if (joint.moves() && !joint.is_mimic()) s.joints.push_back(joint.name);
  draw_positions(s, odd.plan, random);
  see(s, odd.plan, robot.size, random);
  odd.plan.change(s, random);
  if (s.is_tracker()) s.sigma_pixel.reset();
  if (!s.is_tracker()) s.sigma_point.reset();
  replace_file(where / "robot.urdf", robot.urdf);
  save_session(s);
}

// ---- commands
// --------------------------------------------------------------------------------------------------------

std::vector<std::vector<std::string>> commands(const fs::path& session, const fs::path& folder) {
  const std::string s = session.string();
  const Session read = read_session(session);
  std::string position;
  for (std::size_t j = 0; j < read.joints.size(); ++j) position += "0.1 ";
  return {{"check", s, "--json", "-"},
          {"fit", s, "--json", "-"},
          {"fit", s},
          {"inspect", s, "--json", "-"},
          {"fit", s, "--objective", "camera", "--fix-markers", "--json", "-"},
          {"fit", s, "--objective", "angle-axis", "--loss", "huber", "--json", "-"},
          {"fit", s, "--effects", "joint_offset", "marker_slip", "--export", (folder / "c.xml").string()},
          {"predict", (folder / "c.xml").string(), "--robot", (session / "robot.urdf").string(), "--position", position,
           "--json", "-"},
          {"predict", s, "--position", position},
          {"diagnose", s, "--json", "-"},
          {"improve", s},
          {"plan", s, "--count", "2", "--json", "-"},
          {"effective-mass", s, "--json", "-"},
          {"online", s, "--json", "-"},
          {"simulate", "--like", s, "--out", (folder / "out").string(), "--observations", "3"}};
}

bool tells_no_number(const std::string& text) {
  static const std::regex word("(^|[^A-Za-z0-9_])-?(nan|inf)($|[^A-Za-z0-9_])");
  return std::regex_search(text, word);
}

/// What is wrong with a run; empty: nothing.
std::string fault(const CliResult& result) {
  if (result.exit_code != 0 && result.exit_code != 1 && result.exit_code != 2)
    return fmt::format("exit code {}", result.exit_code);
  if (tells_no_number(result.output)) return "a number that is none on standard output";
  if (tells_no_number(result.errors)) return "a number that is none on standard error";
  if (result.exit_code != 2) return "";
  std::string last = result.errors;
  while (!last.empty() && last.back() == '\n') last.pop_back();
  last = last.substr(last.rfind('\n') == std::string::npos ? 0 : last.rfind('\n') + 1);
  if (last.size() < 20 || last.size() > 700) return "no sentence";
  return "";
}

struct Options {
  int every = 1, only = -1;
  fs::path keep;
};

int run(const Options& options) {
  const TemporaryFolder temporary;
  const fs::path folder = options.keep.empty() ? temporary.path : options.keep;
  fs::create_directories(folder);
  int number = 0, sessions = 0, runs = 0, failed = 0, codes[3] = {0, 0, 0};
  double slowest = 0;
  std::string slowest_name;
  for (const OddRobot& robot : odd_robots())
    for (const Oddity& odd : odd_things()) {
      const int mine = number++;
      if (options.only >= 0 ? mine != options.only : mine % options.every != 0) continue;
      const fs::path session = folder / fmt::format("odd_{:03}", mine);
      write_session(robot, odd, static_cast<unsigned>(mine), session);
      ++sessions;
      for (const auto& arguments : commands(session, session)) {
        const auto start = std::chrono::steady_clock::now();
        const CliResult result = test::run_cli(session, arguments, fmt::format("timeout {} ", most_seconds));
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        ++runs;
        if (result.exit_code >= 0 && result.exit_code <= 2) ++codes[result.exit_code];
        if (seconds > slowest) slowest = seconds, slowest_name = fmt::format("{} of {}", arguments[0], mine);
        const std::string wrong = fault(result);
        if (wrong.empty()) continue;
        ++failed;
        std::printf("%d (%s: %s) %s: %s\n  %s\n", mine, robot.name.c_str(), odd.name.c_str(),
                    fmt::format("{}", fmt::join(arguments, " ")).c_str(), wrong.c_str(),
                    result.errors.substr(0, 300).c_str());
        std::fflush(stdout);
      }
      if (options.keep.empty()) fs::remove_all(session);
    }
  std::printf("%d sessions, %d runs: exit code 0 %d times, 1 %d, 2 %d; %d wrong; slowest %.1f s (%s)\n", sessions, runs,
              codes[0], codes[1], codes[2], failed, slowest, slowest_name.c_str());
  return failed == 0 && sessions > 0 ? 0 : 1;
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  handsight::Options options;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--every") options.every = std::max(1, std::atoi(argv[i + 1]));
    if (name == "--only") options.only = std::atoi(argv[i + 1]);
    if (name == "--keep") options.keep = argv[i + 1];
  }
  return handsight::run(options);
}
