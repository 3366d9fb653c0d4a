"""What surrounds a program in a kit of another language than C: files of ``templates``, filled."""
