// SPDX-License-Identifier: GPL-3.0-or-later
// Colours, type and sizes of the whole window, and the absolute scale of residuals: grey as far as noise alone goes.
#pragma once

#include <QColor>
#include <QDBusVariant>
#include <QFont>
#include <QObject>
#include <array>
#include <optional>

namespace handsight::widgets {

enum class ThemeKind { light, dark };

/// One theme's colours by role. All inks have a contrast of 4.6:1 at least against window, panel and sunken.
struct Colors {
  QColor window, panel, sunken, hairline, control_edge;
  QColor ink1, ink2, ink3;
  QColor accent, selected_row;            // blue: selection, focus and the main action, nothing else
  QColor good, care, bad;                 // always with an icon or a word
  QColor good_tint, care_tint, bad_tint;  // grounds for sentences of these kinds
  QColor candidate;                       // purple, always dashed or translucent: not in the model yet
  std::array<QColor, 6> residual;         // residual / sigma below 1, n99, 3, 5, 10, and above
  std::array<QColor, 5> signed_scale;     // from less to more: before - after
  QColor attribution_to_cameras, attribution_to_body, attribution_to_robot;
  std::array<QColor, 3> xyz_curves;    // curves of x, y, z in plots
  std::array<QColor, 3> tcp_axes;      // pure red, green, blue: TCP
  std::array<QColor, 3> tcp_est_axes;  // cyan, yellow, magenta: TCPest
};

/// The colours in force. Widgets read them when they paint and again on QEvent::PaletteChange.
const Colors& colors();
const Colors& theme_colors(ThemeKind kind);
ThemeKind theme();
/// Changes them without a word to anybody: for pictures on paper, painted and done with before the window paints again.
void set_colors(ThemeKind kind);

/// What the desktop prefers, and word of changes: org.freedesktop.appearance color-scheme from the portal by D-Bus;
/// where there is no portal, text that is lighter than the window means dark.
class DesktopTheme : public QObject {
  Q_OBJECT
 public:
  explicit DesktopTheme(QObject* parent = nullptr);
  ThemeKind kind() const { return kind_; }
 signals:
  void changed(handsight::widgets::ThemeKind kind);
 private slots:
  void setting_changed(const QString& group, const QString& key, const QDBusVariant& value);

 private:
  ThemeKind kind_;
};

/// Type: 12, 13, 15 semibold and 24 px at 100 %; nothing is smaller.
enum class TextRole { small, body, title, number };
QFont text_font(TextRole role);
/// The same with digits of equal width: the desktop's font where its digits are, else DejaVu Sans.
QFont number_font(TextRole role);

/// Grid of 4, gaps 8 and 16, rows 24, controls 28 px.
inline constexpr int layout_gap = 8, wide_gap = 16, row_height_px = 24, control_height = 28;

/// n99: the rms of `coordinates` coordinates over sigma that noise alone stays under in 99 of 100 (chi-square): 2.15
/// for a corner (2), 1.82 for a marker in both images (4), 1.48 for an observation of three markers (12).
double noise_limit(int coordinates);

/// The step of the residual scale, 0 to 5, for an rms per coordinate over sigma. Absolute: never scaled to the data.
int residual_step(double rms_over_sigma, int coordinates);

/// The colour of that step; ink 3 where the residual is not known.
QColor residual_color(std::optional<double> rms_over_sigma, int coordinates);

/// "noise", "3", "5", "10", "10+": names of the steps in legends, the first two being one.
QString residual_step_name(int step);

/// A cyclic colour for a direction in the image (rad), after matplotlib's twilight.
QColor direction_color(double angle);

}  // namespace handsight::widgets
