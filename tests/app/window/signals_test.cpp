// SPDX-License-Identifier: Apache-2.0
// What a part of the window says is heard: a click, a key or a menu entry whose signal nobody takes does nothing.
#include <gtest/gtest.h>

#include <QMetaMethod>
#include <map>

#include "app/window/pages.h"
#include "temporary_folder.h"

namespace handsight::test {
namespace {

/// QObject keeps the question to its heirs.
struct Heard : QObject {
  static bool is(const QObject& object, const QMetaMethod& signal) {
    return (object.*&Heard::isSignalConnected)(signal);
  }
};

/// "class::signal(types)" of our own classes, and whether any object of the class is heard.
std::map<std::string, bool> signals_of(const QObject& root) {
  std::map<std::string, bool> all;
  std::vector<const QObject*> objects{&root};
  for (const QObject* child : root.findChildren<QObject*>()) objects.push_back(child);
  for (const QObject* object : objects)
    for (const QMetaObject* kind = object->metaObject(); kind; kind = kind->superClass()) {
      if (!std::string(kind->className()).starts_with("handsight::")) continue;
      for (int m = kind->methodOffset(); m < kind->methodCount(); ++m) {
        const QMetaMethod signal = kind->method(m);
        if (signal.methodType() != QMetaMethod::Signal) continue;
        bool& is_heard = all[std::string(kind->className()) + "::" + signal.methodSignature().toStdString()];
        is_heard = is_heard || Heard::is(*object, signal);
      }
    }
  return all;
}

TEST(Signals, OfEveryPartOfTheWindowAreHeard) {
  const TemporaryFolder folder;
  Desk desk;
  ASSERT_TRUE(desk.window.open(QString::fromStdString(copy_of_sample(folder.path, "hidden_3").string())));
  ASSERT_TRUE(desk.settle());
  for (int n = 1; n <= 5; ++n) {  // pages are made when they are shown
    desk.key(Qt::Key_0 + n, Qt::ControlModifier);
    desk.settle();
  }
  const std::map<std::string, bool> all = signals_of(desk.window);
  EXPECT_GT(all.size(), 40U);
  for (const auto& [name, is_heard] : all) EXPECT_TRUE(is_heard) << name;
}

}  // namespace
}  // namespace handsight::test
