"""Functions of the closed form as C has them: legs, or poses, in lanes, and what is made of their sums."""
