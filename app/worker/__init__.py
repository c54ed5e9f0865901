"""Binding and rotations in a process of their own, so that the window never waits for them.

client.py is the window's side, child.py the other one; requests.py says what crosses the border.
"""
