"""Measurements anybody can run, in folders by subject.

`python -m benchmarks` measures speed; `python -m benchmarks.quality`, `.quality.survey`,
`.resolution`, `.window` and `.speed.drag` what their names say.
"""
