#pragma once
// Borders that two curves or two surfaces share, kept smooth while one of them is edited (what DesignMentor's
// subdivision called "maintain C1"). With b the border's control points and i the next ones inside, degrees p and q
// across the border and h, g the lengths of the end spans there, the two are C1 across it when
//
//     b_X = b_Y   and   i_Y - b_Y = r (b_X - i_X),   r = (p / h) (g / q)      (The NURBS Book, eq. 3.8)
//
// in homogeneous coordinates, for clamped ends. Nobody has to say which borders are meant: those that were C1 before
// the edit stay so.

#include "studio/edit_workspace.hpp"

namespace blossom {

// `edited`, which is `before` with the thing `changed` edited: what is C1 with it in `before` follows, and what follows
// from that. Where the border moves, the points beside it move with it. A made thing that has to follow is given from
// then on. `quick` as in remake.
Workspace seams_kept(const Workspace& before, Workspace edited, std::size_t changed, bool quick = false);

// Whether the two are C1 across a border they share.
bool share_smooth_border(const Geometry&, const Geometry&);

}  // namespace blossom
