// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "base/letters.h"
#include "base/text.h"
#include "certify/touch_page.h"
#include "command.h"
#include "options/target_option.h"
#include "print/circle_grid.h"
#include "printing/outputs.h"
#include "targets/sheet.h"

namespace handsight::cli {
namespace {

struct TargetArguments {
  TargetOptions target;
  std::string out;
  double dots_per_inch = 300;
};

std::string ending_of(const std::string& file) { return lower_case(std::filesystem::path(file).extension().string()); }

std::string file_of(const Sheet& sheet, const TargetArguments& o) {
  const std::string ending = ending_of(o.out);
  if (ending == ".pdf") return pdf_text(sheet);
  if (ending == ".svg") return svg_text(sheet);
  if (ending == ".png") return png_bytes(sheet, o.dots_per_inch);
  throw InputError(message("--out {}: expected a name that ends in .pdf, .svg or .png.", in_quotes(o.out)));
}

/// How to touch, in place of something to look at.
int run_touch(const TargetArguments& o) {
  if (ending_of(o.out) != ".pdf")
    throw InputError(
        message("--out {}: the pages about touching are a PDF; expected a name that ends in .pdf.", in_quotes(o.out)));
  require_output(o.out, "--out");
  write_output(o.out, touch_page_pdf("handsight " HANDSIGHT_VERSION), "--out");
  Output().line(fmt::format("{}: how to touch each kind of fixture, and lines to write down what was touched", o.out));
  return done;
}

int run(const TargetArguments& o) {
  if (o.target.kind == "touch") return run_touch(o);
  const Target target = target_from(o.target);
  require_output(o.out, "--out");
  const Sheet sheet = make_sheet(target);
  write_output(o.out, file_of(sheet, o), "--out");
  const Output out;
  out.line(fmt::format("{}: {}", o.out, describe_target(target)));
  out.line(fmt::format("{} sheet of {:.0f} x {:.0f} mm; print it at 100 % and check its ruler.",
                       sheet.paper == "own size" ? "A" : sheet.paper, 1e3 * sheet.width, 1e3 * sheet.height));
  if (looks_the_same_turned(target))
    Output::note(
        is_circle_grid(target) && !is_asymmetric(target)
            ? "A symmetric grid of circles looks the same after half a turn; an asymmetric one of an odd number of "
              "rows "
              "has two ends that can be told apart."
            : "A board with this number of columns and rows looks the same after half a turn; one column (of circles: "
              "row) more or less tells its ends apart.");
  return done;
}

}  // namespace

Command add_target(const CommandLine& program) {
  auto options = std::make_shared<TargetArguments>();
  const CommandLine command = program.command(
      "target", "A board or tags to print, true to scale (PDF, SVG, PNG), or how to touch (--kind touch)");
  add_target_options(command, options->target, true);
  command.option("--out", options->out, "The file: .pdf, .svg or .png").required();
  command.option("--dpi", options->dots_per_inch, "Dots per inch of a PNG").within(20, 2400);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
