// SPDX-License-Identifier: Apache-2.0
#include "blunders/mended.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "blunders/blunder_kinds.h"
#include "blunders/seen_points.h"
#include "session/new_session.h"
#include "session/session_xml.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

const BlunderKind& required_kind(const std::string& id, const Session& session) {
  if (const BlunderKind* kind = find_blunder_kind(id)) return *kind;
  std::vector<std::string> ids;
  for (const BlunderKind& kind : blunder_kinds())
    if (!kind.places(session).empty() && std::find(ids.begin(), ids.end(), kind.id) == ids.end())
      ids.push_back(kind.id);
  throw InputError(message("{}: there is no blunder of that name; in this session there may be: {}.", in_quotes(id),
                           fmt::join(ids, " ")));
}

std::vector<std::string> list_places(const std::string& id, const Session& session) {
  std::vector<std::string> places;
  for (const BlunderKind& kind : blunder_kinds())
    if (kind.id == id)
      for (const std::string& place : kind.places(session)) places.push_back(place);
  return places;
}

Session quick_points(const Session& session) { return as_point_session(with_few_markers(thinned_session(session))); }

/// Of places that differ by what stands behind "=", the one that leaves least.
std::string best_of(const BlunderKind& kind, const std::vector<std::string>& places, const Session& session) {
  const Session points = quick_points(session);
  std::string best = places.front();
  double least = 1e300;
  for (const std::string& place : places) {
    Session one = points;
    kind.mend(place, one);
    const auto found = solve_hand_eye(one);
    if (found && found->mean_square < least) least = found->mean_square, best = place;
  }
  return best;
}

std::string settled_place(const BlunderKind& kind, const std::string& where, const Session& session) {
  const std::vector<std::string> places = list_places(kind.id, session);
  if (places.empty())
    throw InputError(message("{}: there is nothing in this session that it could be put right in.", kind.id));
  if (where.empty() && places.size() == 1 && !kind.settle) return places.front();
  if (!kind.settle && std::find(places.begin(), places.end(), where) != places.end()) return where;
  if (where.empty())
    throw InputError(message("{}: where? Expected {}:WHERE, one of: {}.", kind.id, kind.id,
                             shortened(fmt::format("{}", fmt::join(places, " ")), 400)));
  if (kind.settle) return where.find('=') == std::string::npos ? kind.settle(where, quick_points(session)) : where;
  std::vector<std::string> alike;
  for (const std::string& place : places)
    if (place.starts_with(where + "=")) alike.push_back(place);
  return alike.empty() ? where : best_of(kind, alike, session);
}

void bring_file(const fs::path& name, const Session& from, const Session& to) {
  const fs::path target = folder(to) / name;
  std::error_code error;
  fs::create_directories(target.parent_path(), error);
  replace_file(target, read_file(folder(from) / name));
}

}  // namespace

namespace {

/// A kind with its place, settled.
struct Placed {
  const BlunderKind* kind;
  std::string place;
};

Placed placed(const Session& session, const std::string& id_with_where) {
  const std::size_t colon = id_with_where.find(':');
  const std::string where = colon == std::string::npos ? "" : id_with_where.substr(colon + 1);
  const BlunderKind& kind = required_kind(id_with_where.substr(0, colon), session);
  return {&kind, settled_place(kind, where, session)};
}

Session put_right(const Session& session, const Placed& one) {
  Session right = session;
  one.kind->mend(one.place, right);
  right.source.reset();  // written anew
  return right;
}

/// The images, each as it should have been: grey PNGs. What was found in those that were wrong is forgotten.
void bring_images_put_right(const std::vector<Placed>& mends, const Session& from, Session& right) {
  for (Observation& o : right.observations) {
    bool any = false;
    for (int c = 0; right.rig && c < right.rig->count(); ++c) {
      std::string& file = o.images[static_cast<std::size_t>(c)];
      std::error_code error;
      if (file.empty() || !fs::exists(folder(from) / file, error)) continue;
      Image image = read_image(folder(from) / file);
      for (const Placed& one : mends)
        if (one.kind->mend_image) image = one.kind->mend_image(one.place, c, image, from);
      file = fs::path(file).replace_extension(".png").generic_string();
      fs::create_directories((folder(right) / file).parent_path(), error);
      write_png(image, folder(right) / file);
      any = true;
    }
    if (any && right.target) std::erase_if(o.sightings, [](const Sighting& s) { return s.by == MarkedBy::tracker; });
  }
}

}  // namespace

Session mended(const Session& session, const std::string& id_with_where) {
  return put_right(session, placed(session, id_with_where));
}

Session write_mended(const Session& session, const std::vector<std::string>& ids, const fs::path& made) {
  if (fs::exists(made / "session.xml"))
    throw InputError(message("{}: there is a session already; take another folder.", shown_path(made)));
  Session right = session;
  std::vector<Placed> mends;
  for (const std::string& id : ids) {
    mends.push_back(placed(right, id));
    right = put_right(right, mends.back());
  }
  std::error_code error;
  fs::create_directories(made, error);
  if (error) throw InputError(message("{}: the folder cannot be made ({}).", shown_path(made), system_text(error)));
  right.file = made / "session.xml";
  if (!right.robot_file.empty()) {
    // The robot may lie in a folder that several sessions share.
    const fs::path robot = folder(session) / right.robot_file;
    right.robot_file = bring_into(robot, made, "");
  }
  if (std::any_of(mends.begin(), mends.end(), [](const Placed& p) { return bool(p.kind->mend_image); }))
    bring_images_put_right(mends, session, right);
  else
    for (const Observation& o : right.observations)
      for (const std::string& image : o.images)
        if (!image.empty() && fs::exists(folder(session) / image, error)) bring_file(image, session, right);
  if (fs::exists(folder(session) / "effects.xml", error)) bring_file("effects.xml", session, right);
  replace_file(right.file, session_text(right));
  return read_session(right.file);
}

}  // namespace handsight
