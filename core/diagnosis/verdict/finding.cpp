// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/finding.h"

#include <algorithm>

namespace handsight {
namespace {

double& share_of_what_moves(const Problem& problem, const std::vector<EffectTerm>& terms, Blame& blame) {
  const std::vector<Circumstances>& all = problem.source->circumstances;
  const std::size_t every = all.size() / 100 + 1;  // a slip begins somewhere on the way
  for (std::size_t i = 0; i < all.size(); i += every) {
    const Sites s = moved_sites(all[i], terms);
    const bool moves_cameras =
        std::any_of(s.cameras.begin(), s.cameras.end(), [](const CameraChange& c) { return !c.is_zero(); });
    if (moves_cameras || !s.mount.isZero() || !s.drift.isZero()) return blame.cameras;
    const bool moves_markers =
        std::any_of(s.markers.begin(), s.markers.end(), [](const auto& m) { return !m.isZero(); });
    if (moves_markers || !s.body.isZero()) return blame.body;
  }
  return blame.robot;
}

}  // namespace

const DiagnosisCandidate* finding_of(const Diagnosis& d) {
  const DiagnosisCandidate* best = nullptr;
  for (const DiagnosisCandidate& c : d.candidates) {
    if (c.ln_bayes_factor < d.threshold || c.terms.empty() || (c.unnamed && !c.refitted)) continue;
    if (c.plausible) return &c;
    if (!best) best = &c;
  }
  return best;
}

Blame blame_by_finding(const Blame& blame, const Diagnosis& d) {
  const DiagnosisCandidate* finding = finding_of(d);
  if (blame.letter == 0 || !finding || !finding->plausible || !finding->explained || !d.model.fit.problem.source)
    return blame;
  const double share = std::clamp(*finding->explained, 0.0, 1.0);
  Blame b = blame;
  for (double* part : {&b.cameras, &b.body, &b.robot}) *part *= 1 - share;
  share_of_what_moves(d.model.fit.problem, finding->terms, b) += share;
  b.letter = b.robot >= std::max(b.cameras, b.body) ? 'R' : b.body >= b.cameras ? 'B' : 'C';
  return b;
}

}  // namespace handsight
