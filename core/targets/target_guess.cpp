// SPDX-License-Identifier: Apache-2.0
#include "targets/target_guess.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "print/circle_grid.h"
#include "print/dictionary.h"
#include "print/target_xml.h"
#include "targets/board_detection.h"
#include "targets/board_hypotheses.h"
#include "targets/drawn_over.h"
#include "targets/tag_survey.h"
#include "targets/target_detection.h"

namespace handsight {
namespace {

bool has_tags(const Target& target) { return target.kind != TargetKind::chessboard; }

/// In how many of the images the target is found.
int found_in(const std::vector<Image>& images, const Target& target) {
  int found = 0;
  const PreparedTarget prepared = prepare(target);
  for (const Image& image : images) found += !detect_target(image, prepared).points.empty();
  return found;
}

bool is_found(const std::vector<Image>& images, const Target& target) {
  return 2 * found_in(images, target) >= static_cast<int>(images.size());
}

// ---- in words

std::string as_option(const std::string& name) {
  std::string option = "--" + name;
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

std::string word_text(const std::string& name, const std::string& value, TargetWording wording) {
  if (wording == TargetWording::attributes) return fmt::format("{}=\"{}\"", name, value);
  return as_option(name) + (value.find(' ') == std::string::npos ? " " + value : fmt::format(" \"{}\"", value));
}

/// What has to be written otherwise; of another kind everything.
std::string changes(const Target& described, const Target& right, TargetWording wording) {
  const auto before = target_words(described), after = target_words(right);
  std::vector<std::string> texts;
  const auto value_in = [](const auto& words, const std::string& name) {
    const auto at = std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.first == name; });
    return at == words.end() ? std::string() : at->second;
  };
  for (const auto& [name, value] : after)
    if (described.kind != right.kind || value_in(before, name) != value)
      texts.push_back(word_text(name, value, wording));
  if (described.kind == right.kind)
    for (const auto& [name, value] : before)
      if (value_in(after, name).empty())
        texts.push_back(word_text(name, name == "layout" ? "new" : name == "first_id" ? "0" : "1", wording));
  return fmt::format("{}", fmt::join(texts, " "));
}

std::string in_code(const std::string& text, TargetWording wording) {
  return wording == TargetWording::options ? "`" + text + "`" : text;
}

Message numbers_text(const std::set<int>& ids) {
  std::vector<Message> runs;
  for (auto at = ids.begin(); at != ids.end();) {
    int last = *at;
    auto next = std::next(at);
    while (next != ids.end() && *next == last + 1) last = *next++;
    runs.push_back(last == *at ? message("{}", last) : message("{} to {}", *at, last));
    at = next;
  }
  if (runs.size() > 8) runs.resize(8), runs.emplace_back("...");
  return joined(runs);
}

Message none_of(const std::vector<Image>& images, const Target& described) {
  return message("None of the {} images that were looked at shows the {}", images.size(), describe_target(described));
}

// ---- chessboards

/// Columns and rows of the lattice of X-corners that most of the images show.
std::optional<Target> other_chessboard(const std::vector<Image>& images, const Target& described) {
  std::map<std::pair<int, int>, int> sizes;
  for (const Image& image : images)
    if (const auto size = chessboard_size(image)) ++sizes[*size];
  std::optional<Target> best;
  int most = 0;
  for (const auto& [size, count] : sizes)
    for (const bool is_turned : {false, true}) {
      Target other = described;
      other.kind = TargetKind::chessboard;
      other.dictionary.clear();
      other.columns = is_turned ? size.second : size.first, other.rows = is_turned ? size.first : size.second;
      if (count <= most || other.columns * other.rows < 6 || other.columns < 2 || other.rows < 2) continue;
      if (found_in(images, other) > 0) best = other, most = count;
    }
  return best;
}

TargetGuess guessed_chessboard(const std::vector<Image>& images, const Target& described, TargetWording wording) {
  const auto other = other_chessboard(images, described);
  if (!other || (other->columns == described.columns && other->rows == described.rows)) return {};
  return {other, message("{}; what they show fits {} (a chessboard is counted by its inner corners, not by its "
                         "squares).",
                         none_of(images, described), in_code(changes(described, *other, wording), wording))};
}

// ---- circles

/// With columns and rows exchanged, in the other layout, or both; an asymmetric grid's columns counted as some do.
TargetGuess guessed_circles(const std::vector<Image>& images, const Target& described, TargetWording wording) {
  for (const bool is_turned : {true, false})
    for (const bool is_other_layout : {false, true}) {
      if (!is_turned && !is_other_layout) continue;
      Target other = described;
      if (is_turned) std::swap(other.columns, other.rows);
      if (is_other_layout) other.dictionary = is_asymmetric(described) ? "symmetric" : "asymmetric";
      if (is_found(images, other))
        return {other, message("{}; what they show fits {}.", none_of(images, described),
                               in_code(changes(described, other, wording), wording))};
    }
  return {};
}

// ---- tags

struct Surveyed {
  TagSurvey way;                   // of the image with most tags, without the tags
  std::vector<TagSurvey> surveys;  // of each image, of those seen in that way
  std::set<int> ids;
  std::size_t most = 0;  // tags in an image
};

Surveyed survey(const std::vector<Image>& images) {
  Surveyed all;
  std::vector<TagSurvey> each;
  for (const Image& image : images) {
    each.push_back(survey_tags(image));
    if (each.back().tags.size() > all.most) all.most = each.back().tags.size(), all.way = each.back();
  }
  for (const TagSurvey& one : each) {
    if (one.dictionary != all.way.dictionary || one.border != all.way.border ||
        one.is_inverted != all.way.is_inverted || one.is_mirrored != all.way.is_mirrored)
      continue;
    for (const SurveyedTag& tag : one.tags) all.ids.insert(tag.id);
    all.surveys.push_back(one);
  }
  return all;
}

/// Does the described dictionary share its tags with this one, as far as they were seen?
bool is_described_dictionary(const Target& described, const std::string& family, int largest_id) {
  if (!has_tags(described)) return false;
  const Dictionary *own = find_dictionary(described.dictionary), *other = find_dictionary(family);
  if (!own || !other || own->bits != other->bits || largest_id >= static_cast<int>(own->codes.size())) return false;
  const auto is_same = [&](const std::string& name) {
    const Dictionary* as = find_dictionary(name);
    return as && std::equal(as->codes.begin(), as->codes.end(), other->codes.begin(),
                            other->codes.begin() + static_cast<std::ptrdiff_t>(as->codes.size()));
  };
  if (is_same(described.dictionary)) return true;
  return described.dictionary.starts_with("tag") && is_same("DICT_APRILTAG_" + described.dictionary.substr(3));
}

/// The roundest number of millimetres near a length, m.
double round_length(double metres) {
  for (const double step : {1e-3, 5e-4})
    if (const double round = step * std::round(metres / step); std::abs(round / metres - 1) < 0.015)
      return 1e-4 * std::round(round / 1e-4);
  return 1e-4 * std::round(metres / 1e-4);
}

/// Sizes of the board by the pitch of its tags, where it is not the one described.
void set_sizes(Target& board, const TagLattice& lattice, const Target& described) {
  constexpr double as_described = 0.06;  // of the pitch: a lens bends it as much
  if (!(board.tag > 0)) board.tag = 0.75 * board.square;
  if (lattice.is_checkered) {
    if (!(board.square > 0)) board.square = lattice.pitch * board.tag;
    if (std::abs(board.square / board.tag / lattice.pitch - 1) > as_described || described.kind != board.kind)
      board.tag = round_length(board.square / lattice.pitch);
  } else if (board.kind == TargetKind::tags) {
    const double pitch = 1 + board.separation / board.tag;
    if (described.kind != board.kind || std::abs(pitch / lattice.pitch - 1) > as_described)
      board.separation = round_length(std::max(0.02, lattice.pitch - 1) * board.tag);
    lay_out_grid(board);
  } else if (described.kind != board.kind || std::abs((1 + board.spacing) / lattice.pitch - 1) > as_described) {
    board.spacing = std::max(0.02, 0.01 * std::round(100 * (lattice.pitch - 1)));
  }
}

/// The board by what one image shows of it; nothing where that is no board or is not found in most of the images.
std::optional<Target> board_by(const TagSurvey& one, const std::vector<Image>& upright, const Surveyed& all,
                               const Target& described) {
  const auto lattice = tag_lattice(one.tags);
  auto board = lattice ? board_with(*lattice, described) : std::nullopt;
  if (!board) return std::nullopt;
  set_sizes(*board, *lattice, described);
  board->border = all.way.border;
  const int largest = *all.ids.rbegin();
  if (!is_described_dictionary(described, all.way.dictionary, largest))
    board->dictionary = smallest_dictionary(all.way.dictionary, largest);
  try {
    check_target(*board, "target");
  } catch (const InputError&) {
    return std::nullopt;
  }
  return is_found(upright, *board) ? board : std::nullopt;
}

/// The first board that fits, by the images that show most tags.
std::optional<Target> board_of(const std::vector<Image>& images, const Surveyed& all, const Target& described) {
  std::vector<Image> upright;
  for (const Image& image : images) {
    upright.push_back(all.way.is_mirrored ? mirrored(image) : image);
    if (all.way.is_inverted) upright.back() = inverted(upright.back());
  }
  std::vector<const TagSurvey*> fullest;
  for (const TagSurvey& one : all.surveys) fullest.push_back(&one);
  std::stable_sort(fullest.begin(), fullest.end(),
                   [](const TagSurvey* a, const TagSurvey* b) { return a->tags.size() > b->tags.size(); });
  for (const TagSurvey* one : fullest)
    if (auto board = board_by(*one, upright, all, described)) return board;
  return std::nullopt;
}

Message seen_otherwise(const TagSurvey& way) {
  if (way.is_mirrored && way.is_inverted)
    return "its tags are there in a mirror and with white for black: the images were turned over and inverted";
  if (way.is_mirrored)
    return "its tags can be read in a mirror only: the images (or the print) are turned over, left for right; undo "
           "that where they are recorded";
  return "its tags are there with white for black: print the board black on white, or invert the images";
}

TargetGuess guessed_tags(const std::vector<Image>& images, const Surveyed& all, const Target& described,
                         TargetWording wording) {
  const auto board = board_of(images, all, described);
  const bool is_odd = all.way.is_inverted || all.way.is_mirrored;
  const Message numbers = message("{} {} of {}", all.ids.size() == 1 ? "tag" : "tags", numbers_text(all.ids),
                                  smallest_dictionary(all.way.dictionary, *all.ids.rbegin()));
  if (!board) {
    const Message odd = is_odd ? message(" ({})", all.way.is_mirrored ? "in a mirror" : "white for black") : Message();
    return {std::nullopt,
            message("{}; what can be read in them are the {}{}.", none_of(images, described), numbers, odd)};
  }
  const std::string change = changes(described, *board, wording);
  if (is_odd)
    return {
        std::nullopt,
        message("{}: {}{}.", none_of(images, described), seen_otherwise(all.way),
                change.empty() ? Message() : message("; besides, what is there fits {}", in_code(change, wording)))};
  if (change.empty()) return {board, ""};
  return {board,
          message("{}; what they show ({}) fits {}.", none_of(images, described), numbers, in_code(change, wording))};
}

constexpr std::size_t least_tags = 4;  // in an image: one or two are read into rubbish now and then

/// Those that half of the images show, two at least.
std::optional<Target> single_tags(const Surveyed& all, std::size_t images) {
  std::map<int, std::size_t> seen;
  for (const TagSurvey& one : all.surveys)
    for (const SurveyedTag& tag : one.tags) ++seen[tag.id];
  Target tags;
  tags.kind = TargetKind::tags;
  for (const auto& [id, count] : seen)
    if (count >= 2 && 2 * count >= images) tags.ids.push_back(id);
  if (tags.ids.empty()) return std::nullopt;
  tags.dictionary = smallest_dictionary(all.way.dictionary, tags.ids.back());
  tags.border = all.way.border;
  tags.tag = 1;
  return tags;
}

}  // namespace

std::optional<Target> shown_target(const std::vector<Image>& images) {
  if (images.empty()) return std::nullopt;
  Target unknown;
  unknown.square = 1;
  const Surveyed all = survey(images);
  const bool are_tags = all.most > 0 && !all.way.is_inverted && !all.way.is_mirrored;
  if (are_tags && all.most >= least_tags)
    if (auto board = board_of(images, all, unknown)) return board;
  if (auto chessboard = other_chessboard(images, unknown); chessboard && is_found(images, *chessboard))
    return chessboard;
  return are_tags ? single_tags(all, images.size()) : std::nullopt;
}

TargetGuess guess_target(const std::vector<Image>& images, const Target& described, TargetWording wording) {
  if (images.empty()) return {};
  const auto drawn_over = std::count_if(images.begin(), images.end(), is_drawn_over);
  if (2 * drawn_over > static_cast<std::ptrdiff_t>(images.size()))
    return {std::nullopt, none_of(images, described) +
                              ": lines or numbers in pure colours are drawn into them, as programs draw what they have "
                              "found; use the images as they came from the camera."};
  if (is_circle_grid(described))
    if (TargetGuess circles = guessed_circles(images, described, wording); circles.target) return circles;
  if (has_tags(described)) {
    const Surveyed all = survey(images);
    if (all.most >= least_tags) return guessed_tags(images, all, described, wording);
    TargetGuess chessboard = guessed_chessboard(images, described, wording);
    if (chessboard.target) return chessboard;
    return {std::nullopt, none_of(images, described) + ", and no tags of any other dictionary are there."};
  }
  const Surveyed all = survey(images);
  if (all.most >= least_tags) return guessed_tags(images, all, described, wording);
  return guessed_chessboard(images, described, wording);
}

}  // namespace handsight
