"""The surface on screen: follows the document, asks the solver, shows the best it knows."""
