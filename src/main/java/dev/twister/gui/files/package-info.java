/** Opening, saving and autosaving scenes, and the settings that are kept between runs. */
package dev.twister.gui.files;
