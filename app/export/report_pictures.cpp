// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/report_pictures.h"

#include "inspect/inspection_rows.h"
#include "widgets/histogram_plot.h"
#include "widgets/residual_map.h"

namespace handsight::app {

std::vector<ReportPicture> report_pictures(const Workbench& bench) {
  std::vector<ReportPicture> pictures;
  const Inspection* all = bench.inspection();
  if (!all) return pictures;
  widgets::HistogramPlot histogram;
  histogram.resize(640, 320);
  histogram.set_noise(all->noise ? std::optional((all->in_pixels ? 1 : 1e3) * *all->noise) : std::nullopt,
                      all->in_pixels ? "px" : "mm");
  histogram.set_unit(bench.units.unit());
  histogram.set_cells(bench.cells());
  histogram.fit();
  pictures.push_back({QObject::tr("Error of each observation against the noise (hatched: what noise alone shows)"),
                      histogram.picture()});
  const Session& s = bench.document.session();
  if (!s.stereo) return pictures;
  widgets::ResidualMap map;
  map.resize(640, 480);
  map.set_image_size(s.stereo->left.width, s.stereo->left.height);
  map.set_unit(bench.units.unit());
  map.set_points(map_points(bench));
  map.fit();
  pictures.push_back({QObject::tr("Residuals over the image, arrows magnified"), map.picture()});
  return pictures;
}

}  // namespace handsight::app
