/** Why a KTX2 texture cannot be read; follows its name. */
export const KTX2_IMAGE = {
  notBasis: 'it is not compressed with Basis Universal, as a glTF must have it',
  damaged: 'its data is damaged',
};
