// SPDX-License-Identifier: GPL-3.0-or-later
// The document's versions of the model: which is shown, which are kept, what second looks make of them.
#include <algorithm>

#include "document/document.h"
#include "words/core_words.h"

namespace handsight::app {

ModelVersionPointer Document::model() const {
  // Fitted here, or at another index that has the same state: before or after actions that leave the model as it is.
  for (const auto& [index, version] : versions_)
    if (version->revision == revision()) return version;
  return nullptr;
}

ModelVersionPointer Document::model_before_second_looks() const {
  for (const auto& [index, version] : versions_)
    if (state_in(version->revision) == state_) return version;
  return nullptr;
}

void Document::show_version(const ModelVersionPointer& version) {
  if (!version || version == shown_) return;
  shown_ = version;
  emit model_changed();
}

std::vector<ModelVersionPointer> Document::versions() const {
  std::vector<ModelVersionPointer> list;
  for (int i = 0; i <= stack_.index(); ++i) {
    const auto found = versions_.find(i);
    list.push_back(found == versions_.end() ? nullptr : found->second);
  }
  const ModelVersionPointer now = model();
  if (now && std::find(list.begin(), list.end(), now) == list.end()) list.back() = now;
  return list;
}

void Document::take_second_looks(const SecondLooks& looks) {
  for (const auto& [id, sightings] : looks) second_looks_[id] = sightings;
  ++looks_;
  emit edited({});
}

bool Document::keeps(const ModelVersion& version) const {
  if (shown_ && same_fit(*shown_, version)) return true;
  return std::any_of(versions_.begin(), versions_.end(),
                     [&](const auto& kept) { return kept.second && same_fit(*kept.second, version); });
}

/// A version knows every observation, which with a hundred thousand is a third of a gigabyte.
void Document::forget_old_versions() {
  constexpr std::size_t fewest = 2;
  const std::size_t most = std::max(fewest, most_kept_ / std::max<std::size_t>(session_->observations.size(), 1));
  // The first stays as long as there is room for more than this one and the one before: all others are compared with
  // it.
  for (auto oldest = versions_.begin(); versions_.size() > most && oldest != versions_.end();) {
    const bool stays = oldest->first == stack_.index() || (most > fewest && oldest == versions_.begin());
    oldest = stays ? std::next(oldest) : versions_.erase(oldest);
  }
}

void Document::take_version(const ModelVersionPointer& version) {
  if (!version || version->revision != revision()) return;
  versions_[stack_.index()] = version;
  shown_ = version;
  forget_old_versions();
  emit model_changed();
}

QString Document::errors_text(int from, int to) const {
  const auto a = versions_.find(from), b = versions_.find(to);
  if (a == versions_.end() || b == versions_.end() || !a->second->fit || !b->second->fit) return {};
  const ErrorAndNoise before = error_and_noise(*a->second), after = error_and_noise(*b->second);
  if (!before.error || !after.error) return {};
  // To as many digits as the header tells them.
  const auto text = [&](double error) { return short_number((before.in_pixels ? 1 : 1e3) * error); };
  return tr(" (%1 → %2 %3)").arg(text(*before.error), text(*after.error), before.in_pixels ? tr("px") : tr("mm"));
}

}  // namespace handsight::app
