// SPDX-License-Identifier: Apache-2.0
// Eigen's decompositions of the matrices that the engine uses, and the workhorses of its products of dynamic matrices:
// compiled once, in compiled_*.cpp beside this, and not again in every source that calls them. Part of the precompiled
// headers (cmake/Handsight.cmake); a source that is compiled without them compiles what it uses itself. The results are
// the same bits.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "geometry/compiled_list.inc"
