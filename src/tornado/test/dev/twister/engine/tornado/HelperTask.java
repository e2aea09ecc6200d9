package dev.twister.engine.tornado;

import uk.ac.manchester.tornado.api.common.TornadoFunctions.Task6;

/** A kernel around one helper: input, three tables, output and number of items. */
public interface HelperTask extends Task6<float[], float[], float[], float[], float[], Integer> {}
