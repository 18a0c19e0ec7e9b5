// SPDX-License-Identifier: MIT
// The six rigid motions of the whole body as a coarse space Z: conjugate gradients with a block preconditioner need
// many iterations to find that a stiff body that is hit moves as a whole, and until they have, momentum is missing.
// Deflation [Nicolaides 1987, "Deflation of conjugate gradients with applications to boundary value problems"] solves
// for these six exactly, in every iteration: Z^T r = 0 whenever the solve stops, so what pushes from outside and what
// the body and its carrier gain agree at any budget. Partly constrained nodes take part in what they are free to do.
#pragma once
#include "solver/rigid_locks.h"

namespace crumple::solver {

class RigidModes {
public:
    // REQUIRES: no node is fixed, partials are listed, the matrix is assembled. Does nothing where float cannot tell
    // the mass of the whole beside its stiffness.
    void prepare(const Model& model, const State& state, Workspace& workspace, std::span<const Partial> partials,
                 const RigidLocks& locks, const Kernels& kernels, const Jobs& jobs);

    // After a partial's taken_count went from 1 to 0 or back; refresh() when all are done.
    void follow(const Model& model, const State& state, Workspace& workspace, const Partial& partial);
    void refresh(const Model& model, const State& state, Workspace& workspace, std::span<const Partial> partials,
                 const RigidLocks& locks, const Kernels& kernels, const Jobs& jobs);

    // Takes out of the residual what rigid motion can answer: changes `change` and the residual, locks included.
    void balance(const Model& model, const State& state, Workspace& workspace, std::span<const Partial> partials,
                 RigidLocks& locks) const;

    // Makes the direction conjugate to the rigid motions, `precise` being what was added to it.
    void deflate(const Model& model, const State& state, Workspace& workspace, std::span<const Partial> partials,
                 RigidLocks& locks, const Kernels& kernels, const Jobs& jobs) const;

private:
    bool is_active_ = false;
    Matrix6 carrier_{};  // T^T of the carried rows of A Z, own mass in it
    Matrix6 inverse_{};  // of Z^T A Z
};

}
