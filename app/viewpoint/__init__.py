"""What the scene is seen through: the camera, how it frames a mesh, how a person moves it."""
