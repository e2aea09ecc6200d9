package dev.twister.gui.edit;

import dev.twister.scene.TrackTarget;

/** All keyframes of one part of a scene at one time; of the camera, also those of its path. */
public record KeyMark(TrackTarget target, double seconds) {}
