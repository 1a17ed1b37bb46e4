"""What the checks share."""
import manylight


def refuse(words, call):
    """A call raises the module's exception with these words in it."""
    try:
        call()
    except manylight.Error as error:
        print(f"    {type(error).__name__}: {error}")
        assert words in str(error), words
        return
    raise AssertionError(f"no refusal: {words}")
