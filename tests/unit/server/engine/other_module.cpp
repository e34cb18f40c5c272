// What is found where aucast-nats.so should be: with OTHER_TAG a module of another build, which may
// have anything but its tag in another place; else no module.
#ifdef OTHER_TAG
struct OtherModule {
  const char* tag;
};

extern "C" const OtherModule aucast_nats_module;
extern "C" const OtherModule aucast_nats_module{OTHER_TAG};
#endif
