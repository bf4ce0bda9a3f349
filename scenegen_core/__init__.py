"""SceneGen: where would this object go in a room, which way should it face, and why?"""
