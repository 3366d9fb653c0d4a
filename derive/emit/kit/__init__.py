"""Texts of a kit: everything that stands around the kernels in the folder that a controller's build takes.

Takes plain numbers and kernels that are already printed and hands back text; knows nothing of files, of
robots as the runtime has them, or of how answers were computed.
"""
