// SPDX-License-Identifier: GPL-3.0-or-later
// One image with what lies over it: corners, markers measured and predicted, axes, the epipolar line, residual arrows.
#pragma once

#include <QImage>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/rigid.h"
#include "widgets/base/cells.h"
#include "widgets/images/image_viewport.h"

namespace handsight::widgets {

struct ImageDrag;

enum class MarkRole {
  measured,   // a ring with the marker's number
  predicted,  // a small cross
  ghost,      // a dashed ring: where it would have to be to be right
};

/// Positions in px of the image; the centre of the top left pixel is (0, 0).
struct ImageMark {
  int marker = 0;
  Vector2 position{0, 0};
  MarkRole role = MarkRole::measured;
  std::optional<double> rms_over_sigma;  // colours a measured mark; absent: neutral
  int coordinates = 2;
  QString text;  // the read-out when it is hovered; empty: number and position
};

/// A frame's axes as they appear in the image.
struct ImageAxes {
  bool is_estimate = false;  // TCPest (cyan, yellow, magenta, spheres) or TCP (red, green, blue, cones)
  Vector2 origin{0, 0};
  std::array<Vector2, 3> tips{Vector2{0, 0}, Vector2{0, 0}, Vector2{0, 0}};
};

/// A residual measured - predicted, drawn from the predicted position, magnified by the view's factor.
struct ImageArrow {
  Vector2 from{0, 0};
  Vector2 residual{0, 0};                // px
  std::optional<double> rms_over_sigma;  // colours it
  int coordinates = 2;
};

/// A corner within reach of the epipolar line, with what is known of it.
struct ImageCandidate {
  int index = 0;  // what signals say
  Vector2 position{0, 0};
  QString label;  // "0.3 px, 1.24 m"
  bool is_taken = false;
};

/// Wheel zooms at the pointer, dragging pans (with the left button where nothing is grabbed, always with the middle
/// one), double click fits (where it is not labelling). What a click does depends on the mode: viewing, it selects the
/// mark under it; labelling, it says where it was and marks can be dragged and nudged. The pointer and keys never
/// change what is shown in it by themselves: signals ask, setters answer.
class ImageView : public QWidget {
  Q_OBJECT
 public:
  explicit ImageView(QWidget* parent = nullptr);
  ~ImageView() override;

  void set_title(const QString& title);        // top left: "Left, 000_left.png"
  void set_image(const QImage& image);         // keeps the viewport where the size is the same, else fits
  void clear(const QString& sentence);         // no image: the sentence in its place
  void set_frame_size(int width, int height);  // without an image: overlays on an empty frame of this size
  void show_frame(int width, int height);      // the same in place of an image; what is being dragged stays so
  void set_corners(std::vector<Vector2> corners);
  void set_marks(std::vector<ImageMark> marks);
  void set_selected_marker(int marker);  // -1: none
  void set_hovered_marker(int marker);
  void set_axes(std::vector<ImageAxes> axes);
  void set_arrows(std::vector<ImageArrow> arrows);
  void set_magnification(double times);               // of the arrows
  void set_epipolar_line(std::vector<Vector2> line);  // as a polyline: distortion bends it; empty: none
  void set_candidates(std::vector<ImageCandidate> candidates);
  void set_hovered_candidate(int index);  // -1: none
  void set_labelling(bool labelling);
  /// Shows dark or pale images with their grey levels spread over all that a screen has; image() stays as it is.
  void set_stretched(bool stretched);
  void set_loupe(bool shown);  // 8 x, beside the pointer, never under it
  void set_viewport(const ImageViewport& viewport);
  void fit();
  void show_point(const Vector2& px, double zoom);  // "Look there"

  const QImage& image() const { return image_; }
  const ImageViewport& viewport() const { return viewport_; }
  const std::vector<ImageMark>& marks() const { return marks_; }
  QPointF to_screen(const Vector2& px) const;  // widget coordinates
  Vector2 to_image(const QPointF& position) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void viewport_changed(const handsight::widgets::ImageViewport& viewport);     // by the user: to move the other along
  void pointed(const handsight::Vector2& px, Qt::KeyboardModifiers modifiers);  // labelling: a click on no mark
  void pointer_moved(const handsight::Vector2& px);
  void pointer_left();
  void marker_selected(int marker);
  void marker_hovered(int marker);  // -1: none
  void marker_dragged(int marker, const handsight::Vector2& px, bool finished, Qt::KeyboardModifiers modifiers);
  void marker_nudged(int marker, const handsight::Vector2& delta);  // px: arrows 0.1, Shift 1
  void marker_removed(int marker);                                  // Delete or the menu
  void marker_renumbered(int marker, int to);                       // a digit key or the menu
  void candidate_chosen(int index);
  void candidate_hovered(int index);
  void read_out(const QString& text);  // empty: nothing under the pointer

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QSizeF frame_size() const;
  int mark_at(const QPointF& position) const;       // index into marks_, measured ones only; -1
  int candidate_at(const QPointF& position) const;  // index into candidates_; -1
  void change_viewport(const ImageViewport& viewport);
  void hover(const QPointF& position);
  bool act_on_marker(QKeyEvent* event);
  QRectF image_area() const;
  ImageViewport fitted() const;
  void paint_image(QPainter& painter) const;
  void paint_corners(QPainter& painter) const;
  void paint_epipolar_line(QPainter& painter) const;
  void paint_axes(QPainter& painter) const;
  void paint_arrows(QPainter& painter) const;
  void paint_marks(QPainter& painter) const;
  void paint_numbers(QPainter& painter) const;
  void paint_candidates(QPainter& painter) const;
  void paint_pointer_loupe(QPainter& painter) const;
  void paint_title(QPainter& painter) const;

  void refresh_shown();
  bool is_inside(const Vector2& px) const;
  Vector2 nearest_inside(const Vector2& px) const;

  QImage image_, shown_;  // shown_: as it is painted
  QString title_, empty_text_;
  int frame_width_ = 0, frame_height_ = 0;
  std::vector<Vector2> corners_, epipolar_line_;
  std::vector<ImageMark> marks_;
  std::vector<ImageAxes> axes_;
  std::vector<ImageArrow> arrows_;
  std::vector<ImageCandidate> candidates_;
  int selected_marker_ = -1, hovered_marker_ = -1, hovered_candidate_ = -1;
  double magnification_ = 1;
  bool is_labelling_ = false, has_loupe_ = false, is_fitted_ = true, is_stretched_ = false;
  ImageViewport viewport_;
  std::optional<QPointF> pointer_;
  std::unique_ptr<ImageDrag> drag_;
};

}  // namespace handsight::widgets
