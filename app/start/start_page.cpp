// SPDX-License-Identifier: GPL-3.0-or-later
#include "start/start_page.h"

#include <QAbstractButton>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "document/sample_titles.h"
#include "start/session_places.h"
#include "widgets/base/cells.h"
#include "widgets/base/icons.h"
#include "widgets/base/theme.h"
#include "widgets/images/image_contrast.h"
#include "workbench/heading.h"

namespace handsight::app {
namespace {

using widgets::colors;
using widgets::TextRole;

constexpr int thumbnail_width = 72, thumbnail_height = 48, plain_height = thumbnail_height + 16;
constexpr double roomy_scale = 1.7;  // of the pictures on a large screen
constexpr int roomy_width = 1500, roomy_height = 900;

/// The first image of a session, small; null where it has none.
QPixmap thumbnail_of(const std::filesystem::path& folder, double ratio) {
  const std::filesystem::path file = first_image(folder);
  if (file.empty()) return {};
  QImageReader reader(QString::fromStdString(file.string()));
  const QSize size = reader.size();
  if (!size.isValid()) return {};
  const QSize wanted = (QSizeF(thumbnail_width, thumbnail_height) * roomy_scale * ratio).toSize();
  reader.setScaledSize(size.scaled(wanted, Qt::KeepAspectRatioByExpanding));
  // As bright as the images themselves are shown.
  QPixmap pixmap = QPixmap::fromImage(widgets::with_stretched_contrast(reader.read()));
  pixmap.setDevicePixelRatio(ratio);
  return pixmap;
}

/// A row to click: a thumbnail, a title and a sentence under it, and how the session stood.
class PlaceButton : public QAbstractButton {
 public:
  PlaceButton(const QString& title, const QString& sentence, QWidget* parent)
      : QAbstractButton(parent), sentence_(sentence) {
    setText(title);
    setAccessibleName(title);
    setAccessibleDescription(sentence);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  /// The image, one for each theme where it was drawn, or without one the icon of the work that begins there.
  void set_picture(const QPixmap& thumbnail, const QPixmap& in_the_dark, const QString& icon) {
    thumbnail_ = thumbnail;
    in_the_dark_ = in_the_dark;
    icon_ = icon;
  }
  /// Per observation rms over noise: a strip in the window's colours.
  void set_state(const QString& state, const std::vector<double>& ratios) {
    state_ = state;
    ratios_ = ratios;
    if (!state.isEmpty()) setAccessibleDescription(sentence_ + ". " + state);
    explain_what_is_not_there();
  }
  void set_roomy(bool is_roomy) {
    scale_ = is_roomy ? roomy_scale : 1;
    updateGeometry();
    update();
  }
  QSize sizeHint() const override { return {480, static_cast<int>(picture_area().height()) + 16}; }

 protected:
  void resizeEvent(QResizeEvent*) override { explain_what_is_not_there(); }
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const auto& c = colors();
    p.setPen(QPen(hasFocus() ? c.accent : c.hairline, hasFocus() ? 2 : 1));
    p.setBrush(underMouse() || isDown() ? c.selected_row : c.panel);
    p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    paint_picture(p, picture_area());
    const double left = text_left(), wide = text_width(), top = (height() - plain_height) / 2.0;
    p.setPen(c.ink1);
    QFont title = widgets::text_font(TextRole::body);
    title.setWeight(QFont::DemiBold);
    p.setFont(title);
    p.drawText(QRectF(left, top + 7, wide, 20), Qt::AlignVCenter,
               p.fontMetrics().elidedText(text(), Qt::ElideRight, static_cast<int>(wide)));
    p.setFont(widgets::text_font(TextRole::small));
    p.setPen(c.ink2);
    if (state_.isEmpty()) {
      p.drawText(QRectF(left, top + 26, wide, text_height()), Qt::AlignTop | Qt::TextWordWrap, sentence_);
      return;
    }
    p.drawText(QRectF(left, top + 26, wide, 18), Qt::AlignVCenter,
               p.fontMetrics().elidedText(state_, Qt::ElideRight, static_cast<int>(wide)));
    paint_strip(p, QRectF(left, top + 47, wide, 8));
  }

 private:
  QRectF picture_area() const { return {8, 8, scale_ * thumbnail_width, scale_ * thumbnail_height}; }
  double text_left() const { return picture_area().right() + 12; }
  double text_width() const { return width() - text_left() - 12; }
  double text_height() const { return (height() + plain_height) / 2.0 - 30; }
  /// Where the state stands in the sentence's place, or the sentence has no room.
  void explain_what_is_not_there() {
    const QRectF room(0, 0, text_width(), 1e4);
    const QFontMetricsF metrics(widgets::text_font(TextRole::small));
    const bool is_whole = metrics.boundingRect(room, Qt::TextWordWrap, sentence_).height() <= text_height() + 2;
    setToolTip(state_.isEmpty() && is_whole ? QString() : sentence_);
  }
  void paint_picture(QPainter& p, const QRectF& area) const {
    const auto& c = colors();
    const QPixmap& thumbnail = widgets::theme() == widgets::ThemeKind::dark ? in_the_dark_ : thumbnail_;
    if (thumbnail.isNull()) {
      p.fillRect(area, c.sunken);
      widgets::draw_icon(p, QRectF(area.center() - QPointF(14, 14), QSizeF(28, 28)), icon_, c.ink3);
      return;
    }
    const QSizeF shown = thumbnail.deviceIndependentSize();
    // All of the area, and what is beyond it left out on both sides.
    const double times = std::max(area.width() / shown.width(), area.height() / shown.height());
    QRectF source(QPointF(), area.size() / times * thumbnail.devicePixelRatio());
    source.moveCenter(QRectF(thumbnail.rect()).center());
    p.setRenderHint(QPainter::SmoothPixmapTransform);
    p.drawPixmap(area, thumbnail, source);
  }
  void paint_strip(QPainter& p, const QRectF& area) const {
    if (ratios_.empty()) return;
    p.setRenderHint(QPainter::Antialiasing, false);
    const double step = std::min(10.0, area.width() / static_cast<double>(ratios_.size()));
    for (std::size_t i = 0; i < ratios_.size(); ++i)
      p.fillRect(
          QRectF(area.left() + step * static_cast<double>(i), area.top(), std::max(step - 1, 1.0), area.height()),
          colors().residual[static_cast<std::size_t>(widgets::residual_step(ratios_[i], 12))]);
  }

  QString sentence_, icon_, state_;
  QPixmap thumbnail_, in_the_dark_;
  std::vector<double> ratios_;
  double scale_ = 1;
};

}  // namespace

StartPage::StartPage(QWidget* parent) : QScrollArea(parent) {
  setObjectName("start_page");
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
}

void StartPage::refresh() {
  is_stale_ = true;
  refused_.clear();
  if (isVisible()) make();
}

void StartPage::showEvent(QShowEvent* event) {
  if (is_stale_) make();
  QScrollArea::showEvent(event);
}

void StartPage::set_refusal(const QString& sentence) {
  refused_ = sentence;
  if (refusal_) show_refusal();
}

void StartPage::show_refusal() {
  refusal_->setText(refused_);
  refusal_->setVisible(!refused_.isEmpty());
}

void StartPage::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  use_the_room();
}

/// On a large screen pictures and rows are larger, and no third of the page stays empty.
void StartPage::use_the_room() {
  if (!column_) return;
  const bool is_roomy = width() >= roomy_width && height() >= roomy_height;
  column_->setMaximumWidth(is_roomy ? 1480 : 1080);
  // On a laptop all of it is in sight without scrolling, in longer languages too.
  is_roomy ? list_->setContentsMargins(24, 32, 24, 24) : list_->setContentsMargins(24, 14, 24, 12);
  for (auto* button : column_->findChildren<QAbstractButton*>())
    if (auto* place = dynamic_cast<PlaceButton*>(button)) place->set_roomy(is_roomy);
}

QGridLayout* StartPage::make_grid() {
  auto* grid = new QGridLayout;
  grid->setSpacing(8);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  list_->addLayout(grid);
  return grid;
}

void StartPage::make() {
  is_stale_ = false;
  content_ = new QWidget(this);
  auto* outer = new QHBoxLayout(content_);
  auto* column = column_ = new QWidget(content_);
  outer->addStretch(1);
  outer->addWidget(column, 100);
  outer->addStretch(1);
  list_ = new QVBoxLayout(column);
  list_->setSpacing(8);
  auto* name = new QLabel(tr("Handsight"), column);
  name->setFont(widgets::text_font(TextRole::number));
  list_->addWidget(name);
  auto* lead = new QLabel(tr("Finds out where a robot's hand really is, and why it is not where its model says. Open a "
                             "session, make one from your images, or try one of these."),
                          column);
  lead->setWordWrap(true);
  list_->addWidget(lead);
  list_->addSpacing(8);

  auto* buttons = new QHBoxLayout;
  auto* open = new QPushButton(tr("Open a session…"), column);
  open->setObjectName("start_open");
  open->setDefault(true);
  auto* make = new QPushButton(tr("New session from images…"), column);
  make->setObjectName("start_new");
  for (QPushButton* b : {open, make}) {
    b->setIcon(widgets::icon(b == open ? "open" : "new_session"));
    b->setIconSize(QSize(24, 16));  // the drawing is square: some air before the words
    b->setMinimumSize(b->sizeHint().width() + 32, 36);
    buttons->addWidget(b);
  }
  buttons->addStretch(1);
  list_->addLayout(buttons);
  connect(open, &QPushButton::clicked, this, &StartPage::open_requested);
  connect(make, &QPushButton::clicked, this, &StartPage::new_requested);
  refusal_ = new QLabel(column);
  refusal_->setObjectName("start_refusal");
  refusal_->setWordWrap(true);
  refusal_->setContentsMargins(12, 8, 12, 8);
  refusal_->setAutoFillBackground(true);
  QPalette tinted = refusal_->palette();
  tinted.setColor(QPalette::Window, colors().bad_tint);
  tinted.setColor(QPalette::WindowText, colors().ink1);
  refusal_->setPalette(tinted);
  list_->addWidget(refusal_);
  show_refusal();
  make_lists(column);
  use_the_room();
  list_->addStretch(1);
  setWidget(content_);
}

void StartPage::make_lists(QWidget* column) {
  const auto recent = recent_sessions();
  if (!recent.empty()) {
    list_->addSpacing(16);
    list_->addWidget(heading(tr("Recent sessions"), column));
    QGridLayout* grid = make_grid();
    for (std::size_t i = 0; i < recent.size() && i < 6; ++i) {
      const QString path = QString::fromStdString(recent[i].file.string());
      auto* row = new PlaceButton(shown_title(recent[i].title), path, column);
      row->setObjectName("recent_" + QString::number(i));
      const QPixmap picture = thumbnail_of(recent[i].file.parent_path(), devicePixelRatioF());
      row->set_picture(picture, picture, "calibrate");
      row->set_state(recent[i].state, recent[i].ratios);
      connect(row, &QAbstractButton::clicked, this, [this, path] { emit session_chosen(path); });
      grid->addWidget(row, static_cast<int>(i) / 2, static_cast<int>(i) % 2);
    }
  }
  const auto samples = sample_sessions();
  if (!samples.empty()) {
    list_->addSpacing(16);
    list_->addWidget(heading(tr("Sample sessions"), column));
    QGridLayout* grid = make_grid();
    for (int i = 0; i < static_cast<int>(samples.size()); ++i) {
      const SampleSession& sample = samples[static_cast<std::size_t>(i)];
      auto* row = new PlaceButton(sample.title, sample.sentence, column);
      const QString id = QString::fromStdString(sample.name);
      row->setObjectName("sample_" + id);
      const QPixmap picture = thumbnail_of(sample.folder, devicePixelRatioF());
      if (picture.isNull())
        row->set_picture(widgets::drawn_picture(id, widgets::ThemeKind::light),
                         widgets::drawn_picture(id, widgets::ThemeKind::dark), "explain");
      else
        row->set_picture(picture, picture, "explain");
      connect(row, &QAbstractButton::clicked, this, [this, id] { emit sample_chosen(id); });
      grid->addWidget(row, i / 2, i % 2);
    }
  }
}

}  // namespace handsight::app
