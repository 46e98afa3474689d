#include "algebra/unfused.h"

namespace hinge {

Mat6 inverse_by_halves(const Mat6& A) {
    const Mat3 P = A.topLeftCorner<3, 3>().inverse(), Q = A.topRightCorner<3, 3>(), PQ = P * Q;
    const Mat3 S = (A.bottomRightCorner<3, 3>() - Q.transpose() * PQ).inverse();
    Mat6 out;
    out.topRightCorner<3, 3>() = -PQ * S;
    out.topLeftCorner<3, 3>() = P - out.topRightCorner<3, 3>() * PQ.transpose();
    out.bottomLeftCorner<3, 3>() = out.topRightCorner<3, 3>().transpose();
    out.bottomRightCorner<3, 3>() = S;
    return 0.5 * (out + out.transpose());
}

Mat12 inertia_matrix(const beam::Inertia& inertia, const Mat3& axes) { return inertia.matrix(axes); }

}  // namespace hinge
