// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "base/error.h"
#include "camera_calibration/board_images.h"
#include "camera_calibration/board_report.h"
#include "camera_calibration/camera_calibration.h"
#include "command.h"
#include "convert/shown_target.h"
#include "options/target_option.h"
#include "print/target_xml.h"
#include "printing/json_values.h"
#include "printing/outputs.h"

namespace handsight::cli {
namespace {

struct CamerasArguments {
  std::vector<std::string> images;
  TargetOptions target;
  std::string out, model = "best";
  Output output;
};

Json target_json(const Target& target) {
  Json json;
  for (const auto& [name, text] : target_words(target)) json[name] = text;
  return json;
}

Json cells_json(const CameraReport& report) {
  Json cells = Json::array();
  for (const ResidualCell& cell : report.cells)
    cells.push_back({{"points", cell.points},
                     {"mean", numbers(cell.mean)},
                     {"rms_pixel", number(cell.points > 0 ? std::optional(cell.rms_pixel) : std::nullopt)}});
  return {{"columns", CameraReport::columns}, {"rows", CameraReport::rows}, {"cells", cells}};
}

Json camera_json(const CameraCalibration& c, std::size_t i, const std::string& name) {
  const Lens& lens = c.bundle.rig.lenses[i];
  const auto& covariance = c.bundle.lens_covariances[i];
  Json parameters = Json::array();
  for (std::size_t k = 0; k < lens.numbers.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    parameters.push_back(
        {{"name", lens.model->numbers[k].name},
         {"value", number(lens.numbers[k])},
         {"sigma", number(covariance ? std::optional(std::sqrt((*covariance)(at, at))) : std::nullopt)},
         {"unit", lens.model->numbers[k].unit}});
  }
  Json json{{"name", name},
            {"width", lens.width},
            {"height", lens.height},
            {"model", lens.model->name},
            {"parameters", parameters},
            {"covariance", covariance ? matrix(*covariance) : Json(nullptr)},
            {"from_first", motion(c.bundle.rig.from_first[i])},
            {"rms_pixel", number(c.cameras[i].rms_pixel)},
            {"images", c.cameras[i].images},
            {"points", c.cameras[i].points},
            {"residual_map", cells_json(c.cameras[i])}};
  const auto& placement = c.bundle.placement_covariances[i];
  json["from_first_covariance"] = placement ? matrix(*placement) : Json(nullptr);
  return json;
}

Json frames_json(const CameraCalibration& c, const GroupedImages& grouped, std::size_t pieces) {
  Json frames = Json::array();
  for (std::size_t i = 0; i < c.bundle.first_from_target.size(); ++i) {
    const auto& pose = c.bundle.first_from_target[i];
    frames.push_back({{"frame", grouped.frames[i / pieces]},
                      {"piece", i % pieces},
                      {"first_from_target", pose ? motion(*pose) : Json(nullptr)},
                      {"held_out_rms_pixel", number(c.held_out.frames[i])}});
  }
  return frames;
}

const char* display_name(BoardShape shape) {
  switch (shape) {
    case BoardShape::held:
      return "described";
    case BoardShape::bent:
      return "bent";
    case BoardShape::within:
      return "within_sigma";
    case BoardShape::free:
      break;
  }
  return "free";
}

Json board_json(const BoardReport& board, const CameraCalibration& c) {
  Json tried = Json::array(), points = Json::array();
  for (const TriedShape& shape : c.shapes)
    tried.push_back({{"shape", display_name(shape.shape)},
                     {"rms_pixel", number(shape.rms_pixel)},
                     {"held_out_rms_pixel", number(shape.held_out_rms_pixel)}});
  for (const Vector3& point : board.points) points.push_back(numbers(point));
  return {{"shape", display_name(board.shape)},
          {"bend", numbers(board.bend)},
          {"bow_m", number(board.bow)},
          {"off_rms_m", number(board.off_rms)},
          {"off_max_m", number(board.off_most)},
          {"points", points},
          {"shapes", tried},
          {"sentences", board.sentences},
          {"warnings", board.warnings}};
}

Json whole_json(const CameraCalibration& c, const BoardReport& board, const DetectedImages& detected,
                const GroupedImages& grouped, const Target& target) {
  Json cameras = Json::array(), images = Json::array(), tried = Json::array();
  for (std::size_t i = 0; i < detected.names.size(); ++i) cameras.push_back(camera_json(c, i, detected.names[i]));
  for (const ReadImage& image : detected.images)
    images.push_back({{"file", image.file.string()},
                      {"camera", detected.names[static_cast<std::size_t>(image.camera)]},
                      {"frame", grouped.frames[static_cast<std::size_t>(image.frame)]},
                      {"points", image.points},
                      {"dropped", image.dropped},
                      {"reason", image.reason.empty() ? Json(nullptr) : Json(image.reason)}});
  for (const TriedModel& model : c.tried)
    tried.push_back({{"model", model.name},
                     {"rms_pixel", model.failure.empty() ? number(model.rms_pixel) : Json(nullptr)},
                     {"held_out_rms_pixel", model.failure.empty() ? number(model.held_out_rms_pixel) : Json(nullptr)},
                     {"failure", model.failure.empty() ? Json(nullptr) : Json(model.failure)}});
  const std::size_t pieces = c.bundle.first_from_target.size() / std::max<std::size_t>(grouped.frames.size(), 1);
  return {{"target", target_json(target)},
          {"converged", c.bundle.converged},
          {"rms_pixel", number(c.bundle.rms_pixel)},
          {"held_out_rms_pixel", number(c.held_out.rms_pixel)},
          {"points", c.bundle.points},
          {"cameras", cameras},
          {"board", board_json(board, c)},
          {"models", tried},
          {"frames", frames_json(c, grouped, std::max<std::size_t>(pieces, 1))},
          {"images", images},
          {"notes", grouped.notes},
          {"warnings", c.warnings}};
}

void print_camera(const Output& out, const CameraCalibration& c, std::size_t i, const std::string& name) {
  const Lens& lens = c.bundle.rig.lenses[i];
  const auto& covariance = c.bundle.lens_covariances[i];
  out.line(fmt::format("{}: {}, {} points in {} images, rms {:.3f} px", name, lens.model->title, c.cameras[i].points,
                       c.cameras[i].images, c.cameras[i].rms_pixel));
  for (std::size_t k = 0; k < lens.numbers.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    const bool is_pixel = lens.model->numbers[k].unit == "px";
    const std::string sigma =
        covariance ? fmt::format("{:.{}f}", std::sqrt((*covariance)(at, at)), is_pixel ? 2 : 5) : "?";
    out.line(fmt::format("  {:<4} {:>12} +- {}", lens.model->numbers[k].name,
                         fmt::format("{:.{}f}", lens.numbers[k], is_pixel ? 3 : 6), sigma));
  }
  if (i == 0) return;
  const Rigid& placed = c.bundle.rig.from_first[i];
  const Vector3 angles = rpy_from_rotation(placed.rotation) * (180 / M_PI);
  const auto& s = c.bundle.placement_covariances[i];
  out.line(fmt::format("  from the first: x {:.3f} y {:.3f} z {:.3f} mm, roll {:.4f} pitch {:.4f} yaw {:.4f} degrees{}",
                       1e3 * placed.translation.x(), 1e3 * placed.translation.y(), 1e3 * placed.translation.z(),
                       angles.x(), angles.y(), angles.z(),
                       s ? fmt::format("; sigma of the turn {:.4f} degrees",
                                       std::sqrt(s->bottomRightCorner<3, 3>().trace() / 3) * 180 / M_PI)
                         : ""));
}

/// Why images are of no use, each reason with the images that have it.
void print_reasons(const DetectedImages& detected, const std::function<void(const std::string&)>& line) {
  constexpr std::size_t most_names = 6;
  std::vector<std::pair<std::string, std::vector<std::string>>> by_reason;
  for (const ReadImage& image : detected.images) {
    if (image.reason.empty()) continue;
    auto at = std::find_if(by_reason.begin(), by_reason.end(),
                           [&](const auto& r) { return r.first == image.reason.english(); });
    if (at == by_reason.end()) at = by_reason.insert(at, {image.reason.english(), {}});
    at->second.push_back(image.file.filename().string());
  }
  for (auto& [reason, files] : by_reason) {
    const std::size_t all = files.size();
    if (all > most_names) files.resize(most_names), files.push_back(fmt::format("... ({} images)", all));
    line(fmt::format("not used: {}: {}", fmt::join(files, ", "), reason));
  }
  for (const ReadImage& image : detected.images)
    for (const int number : image.repeated)
      if (image.points > 0)
        line(fmt::format("{}: tag {} is there several times and is left out", image.file.filename().string(), number));
}

/// The calibration; where it cannot be why, of every image, and what the images show in place of the target.
CameraCalibration calibrated(const DetectedImages& detected, const std::string& model, const Message& in_its_place) {
  try {
    return calibrate_cameras(detected.board, detected.sizes, detected.names, {model});
  } catch (const InputError& error) {
    print_reasons(detected, Output::note);
    if (in_its_place.empty()) throw;
    throw InputError(in_its_place);
  }
}

void print(const CamerasArguments& o, const CameraCalibration& c, const BoardReport& board,
           const DetectedImages& detected) {
  const Output& out = o.output;
  print_reasons(detected, [&](const std::string& line) { out.line(line); });
  for (const TriedModel& model : c.tried)
    out.line(model.failure.empty() ? fmt::format("{:<9} rms {:.4f} px, held out {:.4f} px", model.name, model.rms_pixel,
                                                 model.held_out_rms_pixel)
                                   : fmt::format("{:<9} {}", model.name, model.failure));
  if (c.shapes.size() > 1)
    for (const TriedShape& shape : c.shapes)
      out.line(fmt::format("board {:<12} rms {:.4f} px, held out {:.4f} px", display_name(shape.shape), shape.rms_pixel,
                           shape.held_out_rms_pixel));
  for (std::size_t i = 0; i < detected.names.size(); ++i) print_camera(out, c, i, detected.names[i]);
  out.line(fmt::format("All: rms {:.4f} px of {} points, held out {:.4f} px", c.bundle.rms_pixel, c.bundle.points,
                       c.held_out.rms_pixel));
  for (const Message& sentence : board.sentences) out.line(sentence);
  for (const Message& warning : board.warnings) out.line("! " + warning);
  for (const Message& warning : c.warnings) out.line("! " + warning);
}

/// Nothing was said of the target: what the images show, in the words that say it.
Message shown_text(const GroupedImages& grouped) {
  std::vector<InstantImages> instants;
  for (const auto& file : grouped.cameras.front().files) instants.push_back({0, {file}});
  return shown_target_text(instants);
}

int run(const CamerasArguments& o) {
  const GroupedImages grouped = group_images(std::vector<std::filesystem::path>(o.images.begin(), o.images.end()));
  if (!is_given(o.target))
    if (const Message shown = shown_text(grouped); !shown.empty()) throw InputError(shown);
  const Target target = target_from(o.target);
  std::size_t count = 0;
  for (const CameraImages& camera : grouped.cameras) {
    count += camera.files.size();
    for (const auto& file : camera.files) note_input(file);
  }
  require_output(o.out, "--out");
  o.output.require_places();
  for (const Message& line : grouped.notes) Output::note(line);
  if (looks_the_same_turned(target))
    Output::note("this board looks the same after half a turn: each image is taken as standing upright.");
  Progress progress("images", count);
  const DetectedImages detected = detect_in_images(grouped, target, [&](std::size_t at) { progress.at(at); });
  const Message in_its_place = shown_in_its_place(detected, target);
  CameraCalibration calibration = calibrated(detected, o.model, in_its_place);
  if (!in_its_place.empty()) calibration.warnings.push_back(in_its_place);
  const BoardReport board = board_report(detected.board, calibration, target);
  print(o, calibration, board, detected);
  o.output.json(whole_json(calibration, board, detected, grouped, target));
  if (!o.out.empty()) {
    write_output(o.out, rig_yaml(calibration.bundle.rig, detected.names), "--out");
    o.output.line("Written: " + o.out);
  }
  return calibration.bundle.converged ? done : answer_is_no;
}

}  // namespace

Command add_cameras(const CommandLine& program) {
  auto options = std::make_shared<CamerasArguments>();
  const CommandLine command = program.command("cameras", "Lenses and placement of cameras from images of a board");
  command.option("IMAGES", options->images, "Folders (one a camera) or files; camera and moment are told by the names")
      .required();
  add_target_options(command, options->target, true);
  command.option("--out", options->out, "The rig, as OpenCV's FileStorage (YAML)");
  command.option("--model", options->model, "best (by the held-out error), brown, rational or fisheye")
      .one_of({"best", "brown", "rational", "fisheye"});
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
