"""Linear surface deformation from discrete fundamental forms, with a material map.

deformer = Deformer(V, F, fixed=..., handles=[...], softness=...)
X = deformer.pose([T])
"""

from solver.deform import Deformer
from solver.errors import (
    ConstraintError,
    FactorizationError,
    FileError,
    MaterialError,
    MeshError,
    SolverError,
)
from solver.forms import FundamentalForms, fundamental_forms
from solver.material import PRESETS, Material, interpolate_softness
from solver.mesh import Mesh, load_mesh
from solver.reconstruct import reconstruct

__all__ = [
    "PRESETS",
    "ConstraintError",
    "Deformer",
    "FactorizationError",
    "FileError",
    "FundamentalForms",
    "Material",
    "MaterialError",
    "Mesh",
    "MeshError",
    "SolverError",
    "fundamental_forms",
    "interpolate_softness",
    "load_mesh",
    "reconstruct",
]
