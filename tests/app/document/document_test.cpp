// SPDX-License-Identifier: Apache-2.0
#include "document/document.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <csignal>

#include "base/error.h"
#include "base/files.h"
#include "document/diagnosing.h"
#include "document/refit.h"
#include "document/selection.h"
#include "images/image_source.h"
#include "session/fixtures/list.h"
#include "session/session_xml.h"
#include "temporary_folder.h"
#include "vision/image/image_file.h"

namespace handsight::app {
namespace {

std::filesystem::path sample(const char* name) {
  return std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name;
}

class DocumentTest : public testing::Test {
 protected:
  DocumentTest() {
    std::filesystem::copy(sample("thesis_simulation"), session, std::filesystem::copy_options::recursive);
  }
  template <class Condition>
  static void wait_until(Condition condition) {
    QEventLoop loop;
    QTimer poll, limit;
    QObject::connect(&poll, &QTimer::timeout, [&] {
      if (condition()) loop.quit();
    });
    QObject::connect(&limit, &QTimer::timeout, &loop, &QEventLoop::quit);
    poll.start(1);
    limit.start(20000);
    loop.exec();
    ASSERT_TRUE(condition());
  }
  Edit change(std::int64_t id, Decision decision, std::int64_t joins = 0) {
    EditableState after = read_state(*document.find(id));
    after.decision = decision;
    Edit edit = document.make_edit(QString("set observation %1").arg(id), {{id, after}});
    edit.joins = joins;
    return edit;
  }
  TemporaryFolder folder;
  std::filesystem::path session = folder.path / "session";
  Document document;
};

TEST_F(DocumentTest, TheFitFollowsEveryActionAndItsUndo) {
  Jobs jobs;
  Refit refit(document, jobs);
  document.open(session);
  wait_until([&] { return document.model() != nullptr; });
  const Rigid first = document.model()->fit->tcp_from_body;
  EXPECT_EQ(document.model()->report->used, 6);
  document.perform(change(2, Decision::excluded));
  EXPECT_EQ(document.model(), nullptr) << "a fit of an earlier state is not the model of this one";
  EXPECT_NE(document.shown_model(), nullptr);
  wait_until([&] { return document.model() != nullptr; });
  EXPECT_EQ(document.model()->report->used, 5);
  EXPECT_EQ(document.model()->cause, "set observation 2");
  EXPECT_EQ(document.versions().size(), 2U);
  document.undo();
  wait_until([&] { return document.model() != nullptr; });
  EXPECT_EQ(document.model()->fit->tcp_from_body.translation, first.translation);
  EXPECT_EQ(document.versions().size(), 1U);
}

TEST_F(DocumentTest, VersionsOfAWhileAgoAreForgottenAndFittedAgain) {
  Jobs jobs;
  Refit refit(document, jobs);
  document.keep_at_most(12);  // of six observations: two versions
  document.open(session);
  const auto fitted = [&] { return wait_until([&] { return document.model() != nullptr; }); };
  fitted();
  const auto first = document.model();
  for (const std::int64_t id : {1, 2, 3}) {
    document.perform(change(id, Decision::excluded));
    fitted();
  }
  EXPECT_FALSE(document.keeps(*first));
  EXPECT_TRUE(document.keeps(*document.model()));
  const auto versions = document.versions();
  ASSERT_EQ(versions.size(), 4U);
  EXPECT_EQ(versions[0], nullptr);
  EXPECT_EQ(versions[1], nullptr);
  EXPECT_NE(versions[2], nullptr);
  for (int i = 0; i < 3; ++i) document.undo();
  fitted();
  EXPECT_NE(document.model(), first);
  EXPECT_EQ(document.model()->fit->tcp_from_body.translation, first->fit->tcp_from_body.translation);
}

TEST_F(DocumentTest, TheFirstVersionStaysWhereThereIsRoomForThree) {
  document.keep_at_most(18);
  document.open(session);
  const auto take = [&] {
    document.take_version(make_version(document.session(), {}, document.revision(), ""));
    return document.model();
  };
  const auto first = take();
  for (const std::int64_t id : {1, 2, 3}) {
    document.perform(change(id, Decision::excluded));
    take();
  }
  EXPECT_TRUE(document.keeps(*first)) << "all others are compared with it";
  EXPECT_EQ(document.versions()[1], nullptr);
}

TEST(ShownResiduals, APartOfTheObservationsIsSaidInTheTitle) {
  ModelResiduals residuals;
  residuals.views.problem.observations.resize(3);
  residuals.views.fitted = 3;
  EXPECT_EQ(titled("Where it fails", residuals), "Where it fails");
  residuals.views.fitted = 100;
  EXPECT_EQ(titled("Where it fails", residuals), "Where it fails (3 of 100 observations)");
}

TEST_F(DocumentTest, AStaleFitIsDropped) {
  document.open(session);
  const auto stale = make_version(document.session(), {}, document.revision(), "");
  document.perform(change(1, Decision::excluded));
  document.take_version(stale);
  EXPECT_EQ(document.shown_model(), nullptr);
  document.take_version(make_version(document.session(), {}, document.revision(), ""));
  EXPECT_NE(document.model(), nullptr);
}

TEST_F(DocumentTest, AFitThatIsRefusedLeavesASentence) {
  document.open(session);
  Edit all{.sentence = "excluded all"};
  for (const Observation& o : document.session().observations)
    all.observations.push_back({o.id, read_state(o), {o.sightings, Decision::excluded, ""}});
  document.perform(all);
  const auto version = make_version(document.session(), {}, document.revision(), "");
  EXPECT_EQ(version->fit, nullptr);
  EXPECT_GT(version->refusal.size(), 20);
}

TEST_F(DocumentTest, ActionsThatJoinAreUndoneAsOne) {
  document.open(session);
  const std::int64_t join = document.new_join();
  document.perform(change(0, Decision::accepted, join));
  document.perform(change(1, Decision::accepted, join));
  document.perform(change(0, Decision::rejected, join));
  document.perform(change(3, Decision::excluded));
  EXPECT_EQ(document.undo_stack().count(), 2);
  document.close();
  document.open(session);
  EXPECT_EQ(document.undo_stack().count(), 2) << "read back from the journal";
  document.undo();
  EXPECT_EQ(document.find(0)->decision, Decision::rejected);
  EXPECT_EQ(document.find(1)->decision, Decision::accepted);
  document.undo();
  EXPECT_EQ(document.find(0)->decision, Decision::none);
  EXPECT_EQ(document.find(1)->decision, Decision::none);
}

TEST_F(DocumentTest, SettingsAreActionsToo) {
  document.open(session);
  document.perform({.sentence = "chose the camera objective",
                    .settings = SettingsEdit{document.settings(), {Objective::camera, true}}});
  EXPECT_EQ(document.settings().objective, Objective::camera);
  document.save();
  document.perform(change(0, Decision::excluded));
  document.undo();
  document.undo();
  EXPECT_EQ(document.settings(), ModelSettings{});
}

TEST_F(DocumentTest, AnOpeningThatFailsLeavesWhatWasOpen) {
  document.open(session);
  document.perform(change(0, Decision::excluded));
  EXPECT_THROW(document.open(folder.path / "nowhere"), InputError);
  EXPECT_TRUE(document.is_open());
  EXPECT_EQ(document.find(0)->decision, Decision::excluded);
}

TEST_F(DocumentTest, SavingKeepsWhatTheProgramDoesNotUnderstand) {
  std::string text = read_file(session / "session.xml");
  text.insert(text.find("<observations>"), "<note by=\"me\">torque sensor 3 is noisy</note>\n  ");
  replace_file(session / "session.xml", text);
  document.open(session);
  document.perform(change(4, Decision::excluded));
  document.save();
  const Session again = read_session(session);
  EXPECT_EQ(again.observations[4].decision, Decision::excluded);
  EXPECT_NE(again.source->find("torque sensor 3 is noisy"), std::string::npos);
}

TEST_F(DocumentTest, SavingWorksWithTheStateFoldersDiskFull) {
  document.open(session);
  const std::size_t actions = 3 * read_file(session / "session.xml").size() / 100;
  for (std::size_t i = 0; i < actions; ++i)  // a journal longer than the session
    document.perform(change(4, i % 2 == 0 ? Decision::excluded : Decision::none));
  document.perform(change(5, Decision::excluded));
  const auto journals = state_folder();
  std::uintmax_t longest = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(journals))
    if (entry.is_regular_file()) longest = std::max(longest, entry.file_size());
  ASSERT_GT(longest, session_text(document.session()).size() + 1000);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit full{longest, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &full), 0);
  EXPECT_NO_THROW(document.save());
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(document.is_saved());
  EXPECT_EQ(read_session(session).observations[5].decision, Decision::excluded);
}

TEST(Edits, ReadBackBitForBit) {
  EditableState a, b;
  a.sightings.push_back(seen_at(2, Vector2(1.0 / 3, 2e-300), std::nullopt, MarkedBy::hand));
  Sighting& both = b.sightings.emplace_back();
  both.point = Vector3(0.1, 0.2, 0.3);
  both.by = MarkedBy::tracker;
  see(both, 1, Vector2(-0.1, 7));
  Sighting reading;  // by touch
  reading.point = Vector3(0, 0, 3e-3);
  reading.along = Vector3(0, 0, 1);
  b.sightings.push_back(reading);
  Sighting& length = b.sightings.emplace_back();
  length.point = Vector3(0.2, 0, 0);
  length.reading = fixtures::length.numbers.front().reading;
  b.decision = Decision::rejected;
  b.reason = "\"quoted\"\n and \xc3\xa4";
  const Edit edit{.sentence = "d\xc3\xa9placé",
                  .observations = {{7, a, b}},
                  .settings = SettingsEdit{{}, {Objective::angle_axis, true}},
                  .joins = 12};
  const Edit again = parse_edit(edit_text(edit));
  EXPECT_EQ(again.sentence, edit.sentence);
  EXPECT_EQ(again.joins, 12);
  ASSERT_EQ(again.observations.size(), 1U);
  EXPECT_TRUE(same_state(again.observations[0].before, a));
  EXPECT_TRUE(same_state(again.observations[0].after, b));
  const std::vector<Sighting>& read = again.observations[0].after.sightings;
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[1].along, reading.along);
  EXPECT_EQ(read[1].reading, nullptr);
  EXPECT_EQ(read[2].reading, length.reading);
  EXPECT_EQ(again.settings->after, edit.settings->after);
  Edit with_parts = edit;
  with_parts.observations[0].after.reason = message("rejected: {}", "blurred");
  EXPECT_EQ(parse_edit(edit_text(with_parts)).observations[0].after.reason.form(), "rejected: %1");
  EXPECT_EQ(edit_text(edit).find('\n'), std::string::npos) << "one line";
  EXPECT_THROW(parse_edit("{\"sentence\":1}"), InputError);
}

TEST(SelectionTest, SpeaksOnlyWhenItChangesAndGoesBack) {
  Selection selection;
  int changes = 0;
  QObject::connect(&selection, &Selection::changed, [&] { ++changes; });
  selection.select_marker(4, 1);
  selection.select_marker(4, 1);
  EXPECT_EQ(changes, 1);
  selection.select_many({3, 4, 5});
  EXPECT_EQ(selection.current().marker, 1) << "the current one stays where it is among the many";
  selection.select_observation(9);
  selection.back();
  EXPECT_EQ(selection.current().observation, 4);
  EXPECT_EQ(selection.current().marker, 1);
  selection.up();
  EXPECT_FALSE(selection.current().marker);
  selection.up();
  EXPECT_FALSE(selection.current().observation);
}

TEST(ImageSourceTest, GreyIsTheEnginesOwn) {
  const Session session = read_session(sample("first_steps"));
  ImageSource source;
  const Observation& o = session.observations[3];
  const ShownImage shown = source.image_now(session, o, 0);
  ASSERT_FALSE(shown.image.isNull()) << shown.refusal.toStdString();
  EXPECT_EQ(grey_image(shown.image).pixels, read_image(folder(session) / o.images[0]).pixels);
  const QImage colours = shown.image.convertToFormat(QImage::Format_RGB32);
  EXPECT_EQ(grey_image(colours).pixels, read_image(folder(session) / o.images[0]).pixels);
}

TEST(ImageSourceTest, RefusesInASentence) {
  Session session = read_session(sample("first_steps"));
  Observation o = session.observations[0];
  session.rig->at(0).camera.width = 1280;
  ImageSource source;
  EXPECT_TRUE(source.image_now(session, o, 0).refusal.contains("640 x 480, the camera says 1280 x 480"));
  o.images[1] = "images/none.png";
  EXPECT_TRUE(source.image_now(session, o, 1).refusal.contains("is not there"));
}

/// The window's thread does not wait for a large image: it is told that it is coming, and when it is there.
TEST(ImageSourceTest, ALargeImageComesLater) {
  const TemporaryFolder home;
  Session session = read_session(sample("first_steps"));
  Observation o = session.observations[0];
  session.file = home.path / "session.xml";
  o.images[0] = "large.png";
  QImage large(5000, 4000, QImage::Format_Grayscale8);
  std::uint32_t noise = 1;
  for (int v = 0; v < large.height(); ++v)
    for (int u = 0; u < large.width(); ++u)
      large.scanLine(v)[u] = static_cast<uchar>((noise = 1664525u * noise + 1013904223u) >> 24);
  ASSERT_TRUE(large.save(QString::fromStdString((home.path / "large.png").string()), "PNG", 100));
  session.rig->at(0).camera.width = large.width();
  session.rig->at(0).camera.height = large.height();
  ImageSource source;
  int arrived = 0;
  QEventLoop loop;
  QObject::connect(&source, &ImageSource::arrived, &loop, [&] { ++arrived, loop.quit(); });
  QTimer::singleShot(60000, &loop, &QEventLoop::quit);
  EXPECT_TRUE(source.image(session, o, 0).is_coming);
  EXPECT_TRUE(source.image(session, o, 0).is_coming) << "asked for again it is not read twice";
  loop.exec();
  EXPECT_EQ(arrived, 1);
  EXPECT_EQ(source.image(session, o, 0).image.size(), large.size());
  EXPECT_FALSE(source.is_busy());
}

}  // namespace
}  // namespace handsight::app
