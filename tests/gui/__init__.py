"""Tests that use the window as a person does: real mouse and keyboard events on a real X server."""
