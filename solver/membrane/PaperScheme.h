#pragma once
// The scheme of Boedec, Leonetti, Jaeger (2011) as it is printed, its misprints corrected: flat
// triangles, normals along the curvature vector, nodal loads, material nodes, no row for the
// volume. Kept to compare with; `fast` is its remedied form.

#include "solver/membrane/Buoyancy.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/membrane/Incompressibility.h"

namespace vesicle
{

/// (14)–(25): normals of (19), and the C of (25) for any displacement.
class PaperBending final : public CotanBending
{
public:
  using CotanBending::CotanBending;

protected:
  NormalScheme normals() const override { return NormalScheme::curvature; }
  SparseMatrix linearised(const SparseMatrix& response, const Points&) const override
  {
    return response;
  }
};

/// Rows D of (28)–(31), force F_γ of (32)–(35).
class PaperIncompressibility final : public Incompressibility
{
public:
  ConstraintRows rows(const Surface& surface) const override;
  SparseMatrix force(const Surface& surface) const override;
};

/// (42) with the sign of (46): Bo z n at the nodes, z from the origin.
class PaperBuoyancy final : public Buoyancy
{
public:
  using Buoyancy::Buoyancy;
  TermForce force(const Surface& surface) const override;
};

}
