from __future__ import annotations

from hypothesis import HealthCheck, settings

# The same examples in every run, and no law about time.
settings.register_profile(
    "laws",
    derandomize=True,
    deadline=None,
    database=None,
    max_examples=40,
    suppress_health_check=(HealthCheck.too_slow, HealthCheck.function_scoped_fixture),
)
settings.load_profile("laws")
