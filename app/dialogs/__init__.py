"""The system's own open and save dialogs, each in a process of its own.

A toolkit in the process of the window would fight with it over the events of the system.
"""
