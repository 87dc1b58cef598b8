// SPDX-License-Identifier: Apache-2.0
#include "blunder_output.h"

#include <fmt/format.h>

#include <span>

#include "json_values.h"
#include "session/joined.h"
#include "session/sample.h"

namespace handsight::cli {
namespace {

constexpr int most_observations = 100;  // of a fit that only decides whether to look for blunders

std::string size_text(bool in_pixels, double rms) {
  return in_pixels ? fmt::format("{:.3g} px", rms) : fmt::format("{:.3g} mm", 1e3 * rms);
}

}  // namespace

namespace {

/// Of several sessions: each is looked at by itself, as fitted together one that is wrong spoils the others.
std::vector<Blunder> blunders_of_parts(const Session& joined) {
  std::vector<Blunder> all;
  for (std::size_t p = 0; p < joined.parts.size(); ++p) {
    if (joined.parts[p].fixture >= 0) continue;
    const Session part = part_session(joined, static_cast<int>(p));
    for (Blunder& b : list_blunders(part)) {
      b.session = joined.parts[p].title;
      b.folder = part.file.parent_path().string();
      all.push_back(std::move(b));
    }
  }
  return all;
}

}  // namespace

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

std::optional<TargetSize> find_target_size(const Session& session) {
  if (!session.target && !session.pose_sensor) return std::nullopt;
  try {
    const auto sample = take_sample(session, most_observations, most_observations);
    const Session& judged = sample ? sample->session : session;
    return other_target_size(judged, fit(judged, {.smallest_step = 1e-6}), {.smallest_step = 1e-6});
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<Blunder> list_blunders(const Session& session) {
  if (std::vector<Blunder> reported = blunders_in_files(session); !reported.empty()) return reported;
  try {
    const auto sample = take_sample(session, most_observations, most_observations);
    const Fit quick = fit(sample ? sample->session : session, {.smallest_step = 1e-6});
    return list_blunders(session, quick);
  } catch (const InputError&) {  // nothing to fit, which the command says itself
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
  out.line(fmt::format("! {} With that {} is left in place of {}. {}", size->text,
                       size_text(size->in_pixels, size->rms_after), size_text(size->in_pixels, size->rms_before),
                       size->fix));
}

Json target_size_json(const std::optional<TargetSize>& size) {
  if (!size) return nullptr;
  const std::string unit = size->in_pixels ? "pixel" : "m";
  return {{"scale", number(size->scale)},
          {"sigma", number(size->sigma)},
          {"rms_before_" + unit, number(size->rms_before)},
          {"rms_after_" + unit, number(size->rms_after)},
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
    out.line(fmt::format("{}{}, and with it {} is left in place of {}:", of,
                         blunders.size() == 1 ? "A mistake explains it" : "Two mistakes together explain it",
                         size_text(first.in_pixels, first.rms_after), size_text(first.in_pixels, first.rms_before)));
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
                    {"ln_bayes_factor", b.is_by_fit ? number(b.ln_bayes_factor) : Json(nullptr)},
                    {"together_with", b.together_with}});
    if (!b.session.empty()) list.back()["session"] = b.session;
  }
  return list;
}

std::optional<DistanceDoubt> find_doubtful_distance(const Session& session) {
  try {
    return session.is_touch() ? doubtful_distance(session, fit(session, {}), {}) : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
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
