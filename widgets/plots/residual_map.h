// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals over the image plane, through three lenses.
#pragma once

#include <QStringList>
#include <memory>
#include <optional>

#include "geometry/rigid.h"
#include "widgets/base/cells.h"
#include "widgets/plots/plot_widget.h"

namespace handsight::widgets {

struct ResidualMapLayers;

struct MapPoint {
  ObservationId observation = no_observation;
  int marker = 0;
  int camera = 0;
  Vector2 position{0, 0};  // px
  Vector2 residual{0, 0};  // measured - predicted, right and down, in the map's unit
  std::optional<double> rms_over_sigma;
};

/// size: discs coloured by the residual scale; arrows: exaggerated 1-2-5 with a scale bar; direction: cyclic colour, a
/// cluster of one colour is a bias.
enum class MapLens { size, arrows, direction };

/// The whole image of one or both cameras, v down, with the mean residual per region and how many points it has, so
/// that empty corners show.
class ResidualMap : public PlotWidget {
  Q_OBJECT
 public:
  explicit ResidualMap(QWidget* parent = nullptr);
  void set_image_size(int width, int height);
  void set_points(std::vector<MapPoint> points);
  /// What the residuals are in: px; mm across the line of sight; sigma of one coordinate.
  void set_unit(SizeUnit unit);
  void set_camera(std::optional<int> camera);       // the one whose residuals are shown; nothing: of all
  void set_camera_names(const QStringList& names);  // by camera
  void set_lens(MapLens lens);
  MapLens lens() const { return lens_; }
  void set_regions(bool shown);
  void set_selected(ObservationId id);
  void set_hovered(ObservationId id);
  /// px of the image that one unit of residual is drawn long: 1, 2, 5, 10, ...; three sigma of the noise are never
  /// drawn longer than a twelfth of the image.
  double exaggeration() const;
  void fit() override;

 signals:
  void observation_selected(qint64 id);
  void observation_hovered(qint64 id);
  void observations_selected(const std::vector<qint64>& ids);  // a rectangle, with Shift

 protected:
  void restyle() override;
  std::vector<PlotColumn> columns() const override;
  QString text_at(const QPointF& position) override;
  void clicked_at(const QPointF& position, Qt::KeyboardModifiers modifiers) override;
  void brushed(const QRectF& in_plot) override;
  bool is_empty() const override { return points_.empty(); }
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fill();
  void fill_arrows();
  void fill_regions();
  void ring();
  bool is_shown(const MapPoint& point) const { return !camera_ || point.camera == *camera_; }
  const MapPoint* point_at(const QPointF& position) const;

  std::vector<MapPoint> points_;
  int width_ = 640, height_ = 480;
  std::optional<int> camera_;
  QStringList camera_names_;
  MapLens lens_ = MapLens::arrows;
  SizeUnit unit_ = SizeUnit::pixel;
  bool has_regions_ = true;
  ObservationId selected_ = no_observation, hovered_ = no_observation;
  std::shared_ptr<ResidualMapLayers> layers_;
};

}  // namespace handsight::widgets
