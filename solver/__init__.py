"""Linear surface deformation from discrete fundamental forms, with a material map.

deformer = Deformer(V, F, fixed=..., handles=[...], softness=...)
X = deformer.pose([T])
"""

from solver.deformer import Deformer
from solver.drag import Drag
from solver.errors import (
    ConstraintError,
    FactorizationError,
    FileError,
    MaterialError,
    MeshError,
    SolverError,
)
from solver.forms.fundamental_forms import FundamentalForms, fundamental_forms
from solver.forms.reconstruction import reconstruct
from solver.learning.learn import learn_softness
from solver.mesh.mesh import Mesh, load_mesh
from solver.setup import Setup
from solver.softness.harmonic import interpolate_softness
from solver.softness.material import PRESETS, Material

__all__ = [
    "PRESETS",
    "ConstraintError",
    "Deformer",
    "Drag",
    "FactorizationError",
    "FileError",
    "FundamentalForms",
    "Material",
    "MaterialError",
    "Mesh",
    "MeshError",
    "Setup",
    "SolverError",
    "fundamental_forms",
    "interpolate_softness",
    "learn_softness",
    "load_mesh",
    "reconstruct",
]
