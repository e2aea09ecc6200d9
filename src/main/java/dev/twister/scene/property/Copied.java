package dev.twister.scene.property;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** A record that has a method {@code with...} for each of its components: RecordBuilder writes them. */
@RecordBuilder.Template(
        options = @RecordBuilder.Options(suffix = "Copy", withClassName = "With", enableGetters = false))
@Retention(RetentionPolicy.SOURCE)
@Target(ElementType.TYPE)
public @interface Copied {}
