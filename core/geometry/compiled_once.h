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

// Each of the sources defines one of these as `template`.
#ifndef HANDSIGHT_DYNAMIC_SYMMETRIC
#define HANDSIGHT_DYNAMIC_SYMMETRIC extern template
#endif
#ifndef HANDSIGHT_DYNAMIC_RECTANGULAR
#define HANDSIGHT_DYNAMIC_RECTANGULAR extern template
#endif
#ifndef HANDSIGHT_OF_SIX
#define HANDSIGHT_OF_SIX extern template
#endif
#ifndef HANDSIGHT_OF_THREE
#define HANDSIGHT_OF_THREE extern template
#endif
#ifndef HANDSIGHT_PRODUCTS
#define HANDSIGHT_PRODUCTS extern template
#endif

// Some of these names are Eigen 3.4's own, which another version may not have. Only functions are named that are
// neither inline nor templates of something else: of others `extern template` says nothing.
#if EIGEN_VERSION_AT_LEAST(3, 4, 0) && !EIGEN_VERSION_AT_LEAST(3, 4, 90)
namespace Eigen {

#define HANDSIGHT_SYMMETRIC(WHERE, M)                                                            \
  WHERE SelfAdjointEigenSolver<M>& SelfAdjointEigenSolver<M>::compute(const EigenBase<M>&, int); \
  WHERE LDLT<M>& LDLT<M>::compute(const EigenBase<M>&);                                          \
  WHERE LLT<M>& LLT<M>::compute(const EigenBase<M>&);
// NOLINTBEGIN(bugprone-macro-parentheses): types, not values
#define HANDSIGHT_SOLUTIONS(WHERE, M, B)                                      \
  WHERE void LDLT<M>::_solve_impl_transposed<true, B, B>(const B&, B&) const; \
  WHERE void LLT<M>::_solve_impl_transposed<true, B, B>(const B&, B&) const;
// NOLINTEND(bugprone-macro-parentheses)
namespace sizes {
using Matrix6 = Matrix<double, 6, 6>;
using Vector6 = Matrix<double, 6, 1>;
using Matrix23 = Matrix<double, 2, 3>;
}  // namespace sizes
HANDSIGHT_SYMMETRIC(HANDSIGHT_DYNAMIC_SYMMETRIC, MatrixXd)
HANDSIGHT_SOLUTIONS(HANDSIGHT_DYNAMIC_SYMMETRIC, MatrixXd, VectorXd)
HANDSIGHT_SOLUTIONS(HANDSIGHT_DYNAMIC_SYMMETRIC, MatrixXd, MatrixXd)
HANDSIGHT_SYMMETRIC(HANDSIGHT_OF_SIX, sizes::Matrix6)
HANDSIGHT_SOLUTIONS(HANDSIGHT_OF_SIX, sizes::Matrix6, sizes::Vector6)
HANDSIGHT_SYMMETRIC(HANDSIGHT_OF_THREE, Matrix3d)
HANDSIGHT_SOLUTIONS(HANDSIGHT_OF_THREE, Matrix3d, Vector3d)
#undef HANDSIGHT_SYMMETRIC
#undef HANDSIGHT_SOLUTIONS

HANDSIGHT_DYNAMIC_RECTANGULAR void PartialPivLU<MatrixXd>::compute();
HANDSIGHT_OF_SIX void PartialPivLU<sizes::Matrix6>::compute();
// Of 2 x 3: what Quaternion::FromTwoVectors needs.
HANDSIGHT_OF_THREE JacobiSVD<Matrix3d>& JacobiSVD<Matrix3d>::compute(const Matrix3d&, unsigned int);
HANDSIGHT_OF_THREE JacobiSVD<sizes::Matrix23>& JacobiSVD<sizes::Matrix23>::compute(const sizes::Matrix23&,
                                                                                   unsigned int);
HANDSIGHT_DYNAMIC_RECTANGULAR void HouseholderQR<MatrixXd>::computeInPlace();
HANDSIGHT_DYNAMIC_RECTANGULAR void ColPivHouseholderQR<MatrixXd>::computeInPlace();
HANDSIGHT_DYNAMIC_RECTANGULAR void ColPivHouseholderQR<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;

namespace internal {

HANDSIGHT_PRODUCTS void evaluateProductBlockingSizesHeuristic<double, double, 1, Index>(Index&, Index&, Index&, Index);

#define HANDSIGHT_PRODUCT(L, R) \
  HANDSIGHT_PRODUCTS struct general_matrix_matrix_product<Index, double, L, false, double, R, false, ColMajor, 1>;
HANDSIGHT_PRODUCT(ColMajor, ColMajor)
HANDSIGHT_PRODUCT(ColMajor, RowMajor)
HANDSIGHT_PRODUCT(RowMajor, ColMajor)
HANDSIGHT_PRODUCT(RowMajor, RowMajor)
#undef HANDSIGHT_PRODUCT

// V: whether the vector is a column or lies across one.
#define HANDSIGHT_PRODUCT(M, V)                                                                                       \
  HANDSIGHT_PRODUCTS struct general_matrix_vector_product<Index, double, const_blas_data_mapper<double, Index, M>, M, \
                                                          false, double, const_blas_data_mapper<double, Index, V>,    \
                                                          false, Specialized>;
HANDSIGHT_PRODUCT(ColMajor, ColMajor)
HANDSIGHT_PRODUCT(ColMajor, RowMajor)
HANDSIGHT_PRODUCT(RowMajor, ColMajor)
HANDSIGHT_PRODUCT(RowMajor, RowMajor)
#undef HANDSIGHT_PRODUCT

}  // namespace internal
}  // namespace Eigen
#endif
