// SPDX-License-Identifier: Apache-2.0
#include "blunder_output.h"

#include <fmt/format.h>

#include <span>

#include "json_values.h"
#include "session/joined.h"
#include "session/sample.h"

namespace handsight::cli {

std::string error_text(bool in_pixels, double error) {
  return in_pixels ? fmt::format("{:.3g} px", error) : fmt::format("a mean of {:.3g} mm", 1e3 * error);
}

namespace {

/// "a mean of 5.1 mm is left in place of 150 mm".
std::string left_text(bool in_pixels, double before, double after) {
  const std::string first = error_text(in_pixels, before);
  return fmt::format("{} is left in place of {}", error_text(in_pixels, after),
                     in_pixels ? first : first.substr(first.find_first_of("0123456789")));
}

/// Of several sessions: each is looked at by itself, as fitted together one that is wrong spoils the others.
std::vector<Blunder> blunders_of_parts(const Session& joined) {
  std::vector<Blunder> all;
  for (std::size_t p = 0; p < joined.parts.size(); ++p) {
    if (joined.parts[p].fixture >= 0) continue;
    const Session part = part_session(joined, static_cast<int>(p));
    const std::optional<Fit> fit = first_fit(part);
    std::vector<Blunder> of_part = fit ? list_blunders(part, *fit) : blunders_in_files(part);
    for (Blunder& b : of_part) {
      b.session = joined.parts[p].title;
      b.folder = part.file.parent_path().string();
      all.push_back(std::move(b));
    }
  }
  return all;
}

}  // namespace

std::optional<Fit> first_fit(const Session& session) {
  try {
    const auto sample = take_sample(session, most_in_first_fit, most_in_first_fit);
    return fit(sample ? sample->session : session, {.smallest_step = 1e-6});
  } catch (const InputError&) {  // nothing to fit, which the command says itself
    return std::nullopt;
  }
}

std::vector<Blunder> list_blunders(const Session& session, const Fit& fit) {
  if (!session.parts.empty()) return session.is_touch() ? std::vector<Blunder>() : blunders_of_parts(session);
  if (std::vector<Blunder> reported = blunders_in_files(session); !reported.empty()) return reported;
  if (!may_be_a_blunder(session, fit)) return {};
  Progress progress("looks for mistakes", 100);
  try {
    return find_blunders(session, fit, [&](double share) {
      progress.at(static_cast<std::size_t>(100 * share));
      return true;
    });
  } catch (const InputError& error) {
    // Looking for mistakes is beside what was asked for: what was found without it is reported all the same.
    Output::note(fmt::format("Mistakes of a whole kind could not be looked for: {}", error.what()));
    return {};
  }
}

bool settles_it(const std::optional<TargetSize>& size) {
  constexpr double little = 0.25;
  return size && size->rms_after < little * size->rms_before;
}

void print_target_size(const Output& out, const std::optional<TargetSize>& size) {
  if (!size) return;
  out.line();
  out.line(fmt::format("! {} With that {}. {}", size->text,
                       left_text(size->in_pixels, size->error_before, size->error_after), size->fix));
}

Json target_size_json(const std::optional<TargetSize>& size) {
  if (!size) return nullptr;
  const std::string unit = size->in_pixels ? "pixel" : "m";
  return {{"scale", number(size->scale)},
          {"sigma", number(size->sigma)},
          {"rms_before_" + unit, number(size->rms_before)},
          {"rms_after_" + unit, number(size->rms_after)},
          {"mean_before_m", size->in_pixels ? Json(nullptr) : number(size->error_before)},
          {"mean_after_m", size->in_pixels ? Json(nullptr) : number(size->error_after)},
          {"text", size->text},
          {"fix", size->fix}};
}

namespace {

/// Of one session.
void print_blunders_of_one(const Output& out, const std::string& session_path, std::span<const Blunder> blunders) {
  out.line();
  const Blunder& first = blunders.front();
  const std::string of = first.session.empty() ? "" : fmt::format("Session {}: ", first.session);
  if (!first.is_by_fit)
    out.line(of.empty() ? "A mistake stands in the session:" : of + "A mistake stands in it:");
  else
    out.line(fmt::format("{}{}, and without {} {}:", of,
                         blunders.size() == 1 ? "A mistake explains it" : "Two mistakes together explain it",
                         blunders.size() == 1 ? "it" : "them",
                         left_text(first.in_pixels, first.error_before, first.error_after)));
  std::string fixes;
  for (const Blunder& b : blunders) {
    out.line("  " + b.text);
    out.line("  " + b.fix);
    fixes += " --fix " + display_name(b);
  }
  out.line(fmt::format("  Or: handsight-cli convert {}{} --out NEW", session_path, fixes));
}

}  // namespace

void print_blunders(const Output& out, const std::string& session_path, const std::vector<Blunder>& blunders) {
  for (std::size_t first = 0, end = 0; first < blunders.size(); first = end) {
    while (end < blunders.size() && blunders[end].session == blunders[first].session) ++end;
    const Blunder& b = blunders[first];
    print_blunders_of_one(out, b.folder.empty() ? session_path : b.folder,
                          std::span(blunders).subspan(first, end - first));
  }
}

Json blunders_json(const std::vector<Blunder>& blunders) {
  Json list = Json::array();
  for (const Blunder& b : blunders) {
    const std::string unit = b.in_pixels ? "pixel" : "m";
    list.push_back({{"id", b.id},
                    {"where", b.where},
                    {"text", b.text},
                    {"fix", b.fix},
                    {"rms_before_" + unit, b.is_by_fit ? number(b.rms_before) : Json(nullptr)},
                    {"rms_after_" + unit, b.is_by_fit ? number(b.rms_after) : Json(nullptr)},
                    {"mean_before_m", b.is_by_fit && !b.in_pixels ? number(b.error_before) : Json(nullptr)},
                    {"mean_after_m", b.is_by_fit && !b.in_pixels ? number(b.error_after) : Json(nullptr)},
                    {"ln_bayes_factor", b.is_by_fit ? number(b.ln_bayes_factor) : Json(nullptr)},
                    {"together_with", b.together_with}});
    if (!b.session.empty()) list.back()["session"] = b.session;
  }
  return list;
}

Json doubtful_distance_json(const std::optional<DistanceDoubt>& doubt, const Session& session) {
  if (!doubt) return nullptr;
  const KnownDistance& named = session.distances[static_cast<std::size_t>(doubt->distance)];
  return {{"of", session.fixtures[static_cast<std::size_t>(named.of)].id},
          {"from", session.fixtures[static_cast<std::size_t>(named.from)].id},
          {"by", named.by},
          {"measured", doubt->measured},
          {"text", doubt->text}};
}

}  // namespace handsight::cli
