// SPDX-License-Identifier: Apache-2.0
#include "certify/certificate_pdf.h"

#include <fmt/format.h>

#include "base/degrees.h"
#include "base/sha256.h"
#include "base/text.h"
#include "certify/certificate_plots.h"
#include "certify/pdf_layout.h"

namespace handsight {
namespace {

std::string mm(double m) { return fmt::format("{:.3f}", 1e3 * m); }
std::string mm(const std::optional<double>& m) { return m ? mm(*m) : "-"; }
std::string deg(double rad) { return fmt::format("{:.4f}", degrees * rad); }
std::string deg(const std::optional<double>& rad) { return rad ? deg(*rad) : "-"; }

std::string times(double before, double after) {
  return after > 0 ? fmt::format("{:.1f} times", before / after) : std::string("-");
}

/// What the customer asks first, in one sentence.
std::string summary(const Certificate& c) {
  return fmt::format(
      "Corrected with this calibration the hand was within {} mm of where it was commanded in 95 of 100 measured poses "
      "({} mm uncorrected), every pose judged by a calibration that had not seen it.",
      mm(c.after.p95), mm(c.before.p95));
}

void add_facts(const Certificate& c, PdfLayout& page) {
  page.facts({{"Robot", fmt::format("{}, {} measured joints; hand: link {}", c.robot, c.joints, c.hand)},
              {"Measured with", c.sensor},
              {"Session", c.title},
              {"Observations", fmt::format("{}, of which {} were used{}", c.observations, c.used,
                                           c.shown_nothing ? fmt::format("; {} of these do not show where the hand was",
                                                                         c.shown_nothing)
                                                           : std::string())},
              {"Calibration", c.model_from},
              {"Made", c.date + " (UTC)"},
              {"Software", c.software}});
}

void add_errors(const Certificate& c, PdfLayout& page) {
  page.heading("Error of the hand over the measured poses");
  const ErrorFigures &b = c.before, &a = c.after;
  PdfTable t{{"", "uncorrected", "corrected", "better by"}, {}, {70, 32, 32, 36}};
  t.rows = {{"Position, mean, mm", mm(b.mean), mm(a.mean), times(b.mean, a.mean)},
            {"Position, rms, mm", mm(b.rms), mm(a.rms), times(b.rms, a.rms)},
            {"Position, 95 of 100 below, mm", mm(b.p95), mm(a.p95), times(b.p95, a.p95)},
            {"Position, greatest, mm", mm(b.largest), mm(a.largest), times(b.largest, a.largest)}};
  if (b.rms_turn && a.rms_turn) {
    t.rows.push_back({"Orientation, rms, deg", deg(b.rms_turn), deg(a.rms_turn), times(*b.rms_turn, *a.rms_turn)});
    t.rows.push_back({"Orientation, greatest, deg", deg(b.largest_turn), deg(a.largest_turn),
                      times(*b.largest_turn, *a.largest_turn)});
  }
  page.table(t);
  page.paragraph(fmt::format(
      "Held out: the observations were parted into {} groups, repetitions of a pose together; each group was judged by "
      "a "
      "calibration from the others. Uncorrected is the robot as its file describes it, with the places of sensor and "
      "target fitted. The figures contain the noise of the measurement.",
      c.folds));
}

void add_promise(const Certificate& c, PdfLayout& page) {
  page.heading("What is promised, and how often it held");
  const Coverage& v = c.coverage;
  page.paragraph(fmt::format(
      "For each held-out observation the calibration promised a limit that its error stays below in 95 of 100 cases "
      "(median limit: {} mm, noise of the measurement included). {} of {} errors were inside: {:.1f} %, with a 95 % "
      "interval from {:.1f} to {:.1f} % (Clopper and Pearson). {}",
      mm(c.median_limit), v.inside, v.all, 100.0 * v.inside / std::max(v.all, 1), 100 * v.interval.low,
      100 * v.interval.high,
      v.interval.low <= 0.95 && v.interval.high >= 0.95 ? "The promise of 95 % agrees with that."
      : v.interval.high < 0.95                          ? "That is less than promised: the limits are too narrow."
                               : "That is more than promised: the limits are wider than needed."));
  draw_coverage(c, page);
}

std::string yes(bool holds) { return holds ? "as the standard asks" : "fewer than the standard asks"; }

void add_iso_poses(const IsoTest& iso, PdfLayout& page) {
  PdfTable t{{"Pose", "cycles", "AP before", "AP after", "RP", "AP a,b,c before", "AP a,b,c after", "RP a,b,c"},
             {},
             {16, 14, 20, 20, 18, 28, 28, 26}};
  for (const IsoPose& p : iso.poses) {
    const auto turn = [&](const Vector3& v) { return p.shows_turn ? deg(v.cwiseAbs().maxCoeff()) : std::string("-"); };
    t.rows.push_back({fmt::format("{}", p.first_id), fmt::format("{}", p.before.cycles), mm(p.before.ap),
                      mm(p.after.ap), mm(p.after.rp), turn(p.before.ap_abc), turn(p.after.ap_abc),
                      p.after.rp_abc ? turn(*p.after.rp_abc) : "-"});
  }
  page.paragraph(fmt::format(
      "Pose accuracy AP and repeatability RP ({}); mm and deg, of a, b, c the greatest. A pose is named by its "
      "first observation.",
      yes(iso.has_accuracy)));
  page.table(t);
}

void add_iso_distances(const IsoTest& iso, PdfLayout& page) {
  PdfTable t{{"From", "to", "cycles", "distance", "AD before", "AD after", "RD"}, {}, {20, 20, 20, 28, 27, 27, 28}};
  for (const IsoDistance& d : iso.distances)
    t.rows.push_back({fmt::format("{}", d.from_id), fmt::format("{}", d.to_id), fmt::format("{}", d.after.cycles),
                      mm(d.after.commanded), mm(d.before.ad), mm(d.after.ad), mm(d.after.rd)});
  page.paragraph(fmt::format("Distance accuracy AD and repeatability RD ({}), mm.", yes(iso.has_distance)));
  page.table(t);
}

void add_iso_directions(const IsoTest& iso, PdfLayout& page) {
  PdfTable t{{"Pose", "cycles a direction", "vAP, mm", "vAP a,b,c, deg"}, {}, {30, 45, 45, 50}};
  for (const IsoDirections& d : iso.directions)
    t.rows.push_back({fmt::format("{}", d.first_id), fmt::format("{}", d.cycles), mm(d.figures.vap),
                      deg(d.figures.vap_abc.maxCoeff())});
  page.paragraph(fmt::format("Multi-directional pose accuracy variation vAP ({}).", yes(iso.has_directions)));
  page.table(t);
}

void add_plan(const IsoTest& iso, PdfLayout& page) {
  for (const std::string& sentence : iso.lacking) page.paragraph(sentence);
  if (iso.plan.empty()) return;
  page.paragraph(
      "To record for a test by the standard: these measured poses lie nearest to the places P1 to P5 of the standard's "
      "cube in the space that was measured. Drive to each as often as the table says, in turn; for vAP thirty times "
      "more "
      "along each of the base's x, y and z. Load and speed are to be the rated ones.");
  PdfTable t{{"Place", "cycles", "hand x, y, z, mm", "joints, rad (m)"}, {}, {14, 16, 46, 94}};
  t.words = 4;
  for (const PoseToRecord& p : iso.plan) {
    std::string joints;
    for (const double q : p.position) joints += fmt::format("{}{:.4f}", joints.empty() ? "" : "  ", q);
    t.rows.push_back({p.place, fmt::format("{}", p.cycles),
                      fmt::format("{:.1f}, {:.1f}, {:.1f}", 1e3 * p.hand.x(), 1e3 * p.hand.y(), 1e3 * p.hand.z()),
                      joints});
  }
  page.table(t);
}

void add_iso(const IsoTest& iso, PdfLayout& page) {
  page.heading("ISO 9283");
  if (iso.poses.empty())
    page.paragraph("No pose was attained twice: AP, RP, AD and vAP cannot be told from this session.");
  if (!iso.poses.empty()) add_iso_poses(iso, page);
  if (!iso.distances.empty()) add_iso_distances(iso, page);
  if (!iso.directions.empty()) add_iso_directions(iso, page);
  add_plan(iso, page);
}

void add_effects(const Certificate& c, PdfLayout& page) {
  page.heading("What the calibration holds");
  if (c.effects.empty()) {
    page.paragraph("The places of sensor and target alone: no error of the robot.");
    return;
  }
  constexpr std::size_t most = 24;
  PdfTable t{{"Effect", "of", "number", "value", "sigma", "unit"}, {}, {44, 34, 30, 24, 20, 18}};
  t.words = 3;
  std::size_t all = 0;
  for (const CalibrationEffect& e : c.effects)
    for (const CalibrationParameter& p : e.parameters)
      if (++all <= most)
        t.rows.push_back({e.id, p.of, p.name, fmt::format("{:.4g}", p.value),
                          p.sigma && *p.sigma > 0 ? fmt::format("{:.2g}", *p.sigma) : "held", p.unit});
  page.table(t);
  if (all > most) page.paragraph(fmt::format("and {} numbers more, in the calibration file.", all - most));
}

void add_files(const Certificate& c, PdfLayout& page) {
  page.heading("Files");
  page.paragraph("SHA-256 of the files that this certificate was made from.");
  for (const CertifiedFile& f : c.files) {
    const double y = page.room(9);
    page.pdf().text(PdfLayout::left, y + 3.4, fmt::format("{}: {}, {} bytes", f.what, shortened(f.name, 60), f.bytes),
                    8.5);
    page.pdf().text(PdfLayout::left + 4, y + 7.2, f.sha256, 8, PdfFont::mono);
  }
}

void add_signatures(PdfLayout& page) {
  const double y = page.room(26) + 18;
  for (const auto& [x, text] :
       {std::pair(PdfLayout::left, "Place and date"), std::pair(PdfLayout::left + 60, "Measured by"),
        std::pair(PdfLayout::left + 120, "Released by")}) {
    page.pdf().line(x, y, x + 50, y, 0.25);
    page.pdf().text(x, y + 4, text, 8);
  }
}

}  // namespace

std::string certificate_number(const Certificate& c) {
  std::string all = c.date;
  for (const CertifiedFile& f : c.files) all += f.sha256;
  return sha256(all).substr(0, 8);
}

std::string certificate_pdf(const Certificate& c) {
  const std::string number = certificate_number(c);
  PdfLayout page("Certificate of robot calibration " + number, c.software,
                 fmt::format("Certificate {} of {}, {}", number, shortened(c.robot, 40), c.date));
  page.title("Certificate of robot calibration", fmt::format("No. {}", number));
  add_facts(c, page);
  page.skip(2);
  page.paragraph(summary(c), 10.5);
  add_errors(c, page);
  add_promise(c, page);
  if (!c.expected.empty()) {
    page.heading("Expected error over the workspace");
    page.paragraph(
        "Each joint anywhere between the least and the greatest value that was measured; the mean of each cell. Beyond "
        "the measured poses the limit is what the calibration promises, not what was measured. All errors are those of "
        "the "
        "hand against the link that carries the sensor or, with the sensor on the hand, the target.");
    draw_maps(c, page);
  }
  add_iso(c.iso, page);
  add_effects(c, page);
  add_files(c, page);
  add_signatures(page);
  return page.bytes();
}

}  // namespace handsight
