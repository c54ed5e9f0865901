"""Softness learned from poses."""
