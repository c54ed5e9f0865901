"""Discrete fundamental forms, and the surface that they determine. [Wang, Liu & Tong 2012]"""
