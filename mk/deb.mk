# Debian packages, unsigned, in build/deb. They are built of a copy of the files that git knows, so that nothing is left
# in the working tree. debian/control lists the packages that the build needs.

DEB := build/deb
DEB_SOURCE := $(DEB)/manylight-$(VERSION)
DEB_PACKAGES := build-essential debhelper dh-python dpkg-dev fakeroot lintian pybuild-plugin-pyproject python3-cffi python3-dev python3-mesonpy

# Debian's Python and tools, and no others of the user's.
DEB_PATH := /usr/sbin:/usr/bin:/sbin:/bin

# appstreamcli asks for a homepage, which the project has not. Older releases of lintian refuse a tag that they do not know.
SUPPRESSED = $$(lintian-explain-tags --list-tags | grep -x appstream-metadata-validation-failed | sed 's/^/--suppress-tags /')

.PHONY: deb
deb: deps
	@test/install-packages $(DEB_PACKAGES)
	@rm -rf $(DEB) && mkdir -p $(DEB_SOURCE)
	$(Q)git ls-files -z | tar -c --null -T - | tar -x -C $(DEB_SOURCE)
	$(Q)sed -i '/^# The tag abi3/,$$d' $(DEB_SOURCE)/pyproject.toml
	$(Q)cd $(DEB_SOURCE) && PATH=$(DEB_PATH) dpkg-buildpackage --unsigned-source --unsigned-changes
	$(Q)lintian --fail-on error,warning $(SUPPRESSED) $(DEB)/*.changes
