// SPDX-License-Identifier: Apache-2.0
// correct_a_pose SESSION: reads a session, finds what the robot's model lacks, and prints the joint angles that bring
// the hand to where its first pose was meant to be.
#include <handsight/handsight.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "Usage: correct_a_pose SESSION\n");
    return 2;
  }
  try {
    const handsight::Session session = handsight::read_session(argv[1]);

    // The model as the robot is described: how far is the hand from where it should be?
    const handsight::Model described;
    const handsight::Fit plain = handsight::fit(session, described);
    const handsight::FitReport before = handsight::report(session, plain, described);
    std::printf("%s: %d observations, held out %.3f px\n", session.title.c_str(), before.used,
                before.held_out.rms_pixel.value_or(0));

    // What is missing in it?
    const handsight::Improvement found = handsight::improve(session, described);
    for (const handsight::ModelEffect& effect : handsight::make_model(found).effects)
      std::printf("  found: %s %s\n", effect.id.c_str(), effect.place.c_str());
    std::printf("  held out %.3f px\n", found.last.report.held_out.rms_pixel.value_or(0));

    // The angles to command, and how near the hand comes.
    const handsight::CalibratedRobot robot = handsight::calibrated_robot(session, found);
    const Eigen::VectorXd& wanted = session.observations.front().position;
    const handsight::Correction command = handsight::correct(robot, wanted);
    for (Eigen::Index joint = 0; joint < wanted.size(); ++joint)
      std::printf("  %s: %+.6f rad in place of %+.6f\n", session.joints[static_cast<std::size_t>(joint)].c_str(),
                  command.position[joint], wanted[joint]);
    std::printf("  off by %.3f mm as commanded, %.6f mm corrected, +- %.3f mm\n", 1e3 * command.error_before_m,
                1e3 * command.error_after_m, 1e3 * command.sigma_m);

    // For the next program, and for other software.
    handsight::save_calibration("calibration.xml", robot);
    const handsight::ExportedFile urdf = handsight::save_robot("calibrated.urdf", robot, "urdf");
    std::printf("  calibrated.urdf is %.3f mm from the calibration, the robot as described %.3f mm\n",
                1e3 * urdf.left.value_or(0), 1e3 * urdf.nominal.value_or(0));

    // Weeks later: is everything as it was? Here the same session stands for the new one.
    std::printf("  %s\n", handsight::compare(robot, session).sentence.english().c_str());
    return command.reached ? 0 : 1;
  } catch (const handsight::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
