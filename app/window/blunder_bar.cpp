// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/blunder_bar.h"

#include <fmt/format.h>

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "base/error.h"
#include "blunders/blunders_in_files.h"
#include "blunders/find_blunders.h"
#include "blunders/mended.h"
#include "session/sample.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

/// Times the noise: far beyond what robots lack, so that the search is worth its seconds without being asked for.
constexpr double lost = 50;
constexpr int most_observations = 100;

bool is_lost(const Session& session, const ModelVersion& model) {
  const StoryError e = error_and_noise(model);
  return may_be_a_blunder(session, *model.fit) && (!e.ratio() || *e.ratio() > lost);
}

/// Of the session alone, with nothing in its model; an answer that nothing was found where it cannot be fitted.
std::vector<Blunder> searched(const Session& session, JobControl& control) {
  if (std::vector<Blunder> reported = blunders_in_files(session); !reported.empty()) return reported;
  try {
    const auto sample = take_sample(session, most_observations, most_observations);
    const Session& few = sample ? sample->session : session;
    const Fit quick = fit(few, {.smallest_step = 1e-6});
    std::vector<Blunder> found = find_blunders(few, quick, [&](double share) {
      control.report(share);
      return !control.is_cancelled();
    });
    const bool may_be_order = sample && (found.empty() || found.front().id == "pairing_order");
    if (!may_be_order || control.is_cancelled()) return found;
    return find_wrong_order(session, fit(session, {.smallest_step = 1e-6}));  // of all, which a part does not show
  } catch (const InputError&) {
    return {};
  }
}

/// As the figure of errors beside it has it.
QString error_text(const Blunder& b, double error) {
  return b.in_pixels ? widgets::with_unit_text(error, QObject::tr("px"))
                     : widgets::with_unit_text(1e3 * error, QObject::tr("mm in the mean"));
}

}  // namespace

std::filesystem::path mended_folder(const Session& session) {
  const std::filesystem::path old = std::filesystem::absolute(folder(session)).lexically_normal();
  const std::filesystem::path named = old.has_filename() ? old : old.parent_path();
  std::error_code error;
  for (int i = 1;; ++i) {
    std::filesystem::path made =
        named.parent_path() / (named.filename().string() + (i == 1 ? "_mended" : fmt::format("_mended_{}", i)));
    if (!std::filesystem::exists(made, error)) return made;
  }
}

BlunderBar::BlunderBar(Workbench& workbench, QWidget* parent) : QFrame(parent), workbench_(workbench) {
  setObjectName("blunders");
  setAutoFillBackground(true);
  const auto label = [this](const char* name) {
    auto* made = new QLabel(this);
    made->setObjectName(name);
    made->setWordWrap(true);
    made->setTextFormat(Qt::PlainText);
    made->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return made;
  };
  text_ = label("blunders_text");
  sizes_ = label("blunders_sizes");
  said_ = label("blunders_said");
  const auto button = [this](const char* name, const QString& text) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(name);
    made->setMinimumHeight(widgets::control_height);
    made->setAutoDefault(false);
    return made;
  };
  write_ = button("blunders_write", tr("Write the session put right"));
  write_->setToolTip(tr("Beside the old one, which stays as it is"));
  open_ = button("blunders_open", tr("Open it"));
  auto* away = new QToolButton(this);
  away->setObjectName("blunders_away");
  away->setText(tr("Put away"));
  away->setMinimumHeight(widgets::control_height);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(widgets::layout_gap, 4, widgets::layout_gap, 4);
  grid->setVerticalSpacing(2);
  grid->addWidget(text_, 0, 0);
  grid->addWidget(sizes_, 1, 0);
  grid->addWidget(said_, 2, 0);
  grid->setColumnStretch(0, 1);
  grid->addWidget(write_, 0, 1, 2, 1, Qt::AlignTop);
  grid->addWidget(open_, 0, 2, 2, 1, Qt::AlignTop);
  grid->addWidget(away, 0, 3, 2, 1, Qt::AlignTop);
  connect(write_, &QPushButton::clicked, this, &BlunderBar::write);
  connect(open_, &QPushButton::clicked, this, [this] { emit open_wanted(written_); });
  connect(away, &QToolButton::clicked, this, [this] { take({}); });
  connect(&workbench.document, &Document::opened, this, [this] {
    has_looked_ = false;
    take({});
  });
  connect(&workbench.document, &Document::closed, this, [this] {
    workbench_.background.cancel("blunders");
    take({});
  });
  connect(&workbench.document, &Document::model_changed, this, &BlunderBar::follow);
  refresh();
}

/// Once a session, where its first fit is lost.
void BlunderBar::follow() {
  const ModelVersionPointer model = workbench_.document.model();
  if (has_looked_ || !model || !model->fit || !model->fit->effects.empty()) return;
  has_looked_ = true;
  if (is_lost(workbench_.document.session(), *model)) search(false);
}

void BlunderBar::look() {
  if (workbench_.document.is_open()) search(true);
}

void BlunderBar::search(bool is_asked_for) {
  workbench_.background.start<std::vector<Blunder>>(
      "blunders", tr("Looking for mistakes of a whole kind"),
      [session = workbench_.document.shared_session()](JobControl& control) { return searched(*session, control); },
      [this, is_asked_for](const std::vector<Blunder>& found) {
        take(found);
        if (found.empty() && is_asked_for)
          emit workbench_.document.noticed(tr("No mistake of a whole kind makes this session right."));
      });
}

void BlunderBar::take(const std::vector<Blunder>& found) {
  workbench_.set_blunders(found);
  refresh();
}

void BlunderBar::refresh() {
  written_.clear();
  said_->hide();
  open_->hide();
  setVisible(!found().empty());
  if (found().empty()) return;
  QStringList lines;
  for (const Blunder& b : found()) lines << translated(b.text) + ' ' + translated(b.fix);
  text_->setText(QString::fromUtf8("▲  ") + lines.join('\n'));
  const Blunder& first = found().front();
  sizes_->setVisible(first.is_by_fit);
  sizes_->setText((found().size() == 1 ? tr("Fitted with it, %1 are left; put right, %2.")
                                       : tr("Fitted with them, %1 are left; both put right, %2."))
                      .arg(error_text(first, first.error_before), error_text(first, first.error_after)));
  write_->setEnabled(true);
  QPalette tinted = palette();
  tinted.setColor(QPalette::Window, widgets::colors().care_tint);
  setPalette(tinted);
}

void BlunderBar::write() {
  std::vector<std::string> ids;
  for (const Blunder& b : found()) ids.push_back(display_name(b));
  const std::filesystem::path made = mended_folder(workbench_.document.session());
  try {
    write_mended(workbench_.document.session(), ids, made);
    written_ = QString::fromStdString(made.string());
    write_->setEnabled(false);
    open_->show();
    say(tr("Written: %1").arg(written_), false);
  } catch (const std::exception& error) {
    say(translated_error(error), true);
  }
}

void BlunderBar::say(const QString& sentence, bool is_refusal) {
  QPalette inks = said_->palette();
  inks.setColor(QPalette::WindowText, is_refusal ? widgets::colors().bad : widgets::colors().ink1);
  said_->setPalette(inks);
  said_->setText(sentence);
  said_->show();
}

void BlunderBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ApplicationPaletteChange && !found().empty()) {
    QPalette tinted = palette();
    tinted.setColor(QPalette::Window, widgets::colors().care_tint);
    setPalette(tinted);
  }
  QFrame::changeEvent(event);
}

}  // namespace handsight::app
